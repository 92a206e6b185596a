//! Hover for a program: its signature, and the comment at the start of the code.

use val3_analysis::db::{Db, File, Project};
use val3_analysis::items::project::{items, signature};
use val3_analysis::items::{parse, program};
use val3_analysis::ty::brackets;
use val3_syntax::{SyntaxKind, decode_entities};

use crate::markdown::{code, fenced, plain};

pub(super) fn hover(db: &dyn Db, project: Project, name: &str) -> Option<String> {
    let file = *items(db, project).programs.get(name)?;
    let mut text = fenced(&line(db, project, file));
    if let Some(comment) = comment(db, file) {
        text.push('\n');
        text.push_str(&comment);
    }
    Some(text)
}

/// Signature line, for example `public program pick(num x_n, string& x_s)`.
pub(crate) fn line(db: &dyn Db, project: Project, file: File) -> String {
    let signature = signature(db, project, file);
    let params: Vec<String> = signature
        .params
        .iter()
        .map(|param| {
            let reference = if param.by_reference { "&" } else { "" };
            format!("{}{reference} {}{}", param.base.display(db), param.name, brackets(param.container))
        })
        .collect();
    let public = if signature.public { "public " } else { "" };
    format!("{public}program {}({})", signature.name, params.join(", "))
}

/// Comment before the first statement of a program, as Markdown. Tags such as `//\brief` and `//\param x what` are
/// parsed. The fallback is the description in the header.
pub(crate) fn comment(db: &dyn Db, file: File) -> Option<String> {
    let lines: Vec<String> = head_lines(db, file).iter().map(|line| comment_line(line)).collect();
    let text = lines.join("\n").trim().to_owned();
    Some(text).filter(|text| !text.is_empty()).or_else(|| description(db, file))
}

/// Description of a parameter in the program's comment.
pub(super) fn parameter(db: &dyn Db, file: File, name: &str) -> Option<String> {
    head_lines(db, file).iter().find_map(|line| {
        let ("param", rest) = tag(line)? else { return None };
        let (named, about) = rest.split_once(char::is_whitespace)?;
        (named == name).then(|| about.trim().to_owned())
    })
}

/// Comments between `begin` and the first statement.
fn head_lines(db: &dyn Db, file: File) -> Vec<String> {
    let parse = parse(db, file);
    let Some(block) = program::code(parse.view()) else { return Vec::new() };
    let pieces = block.children_with_tokens();
    let tokens = pieces.skip_while(|piece| piece.as_token().is_none_or(|token| token.kind() != SyntaxKind::BEGIN_KW));
    let tokens = tokens.skip(1).map_while(|piece| piece.into_token()).take_while(|token| token.kind().is_trivia());
    let comments = tokens.filter(|token| token.kind() == SyntaxKind::COMMENT);
    comments.map(|comment| decode_entities(comment.text()).into_owned()).collect()
}

/// `<Description>` of a program, which some tools write as comment lines.
fn description(db: &dyn Db, file: File) -> Option<String> {
    let parse = parse(db, file);
    let element = program::element(parse.view())?.child(&["Description", "description"])?;
    let range = std::ops::Range::<usize>::from(element.view().range());
    let text = file.text(db).get(range)?;
    let inside = text.split_once('>')?.1.rsplit_once("</")?.0.trim();
    let inside = inside.strip_prefix("<![CDATA[").and_then(|text| text.strip_suffix("]]>")).unwrap_or(inside);
    let lines: Vec<String> = decode_entities(inside).lines().map(|line| comment_line(line.trim())).collect();
    Some(lines.join("\n").trim().to_owned()).filter(|text| !text.is_empty())
}

/// Text of a comment as escaped Markdown. A line without letters and digits, for example a line of dashes, yields no
/// text.
fn comment_line(comment: &str) -> String {
    let text = comment.trim_start_matches('/').trim();
    if !text.contains(|letter: char| letter.is_alphanumeric()) {
        return String::new();
    }
    match tag(comment) {
        Some(("brief", rest)) => plain(rest),
        Some(("param", rest)) => {
            let (name, about) = rest.split_once(char::is_whitespace).unwrap_or((rest, ""));
            format!("- {}: {}", code(name), plain(about))
        }
        Some((tag, rest)) => format!("- {}: {}", plain(tag), plain(rest)),
        None => plain(text),
    }
}

/// Tag and text of a comment in the form `//\name rest`, `//@name rest` or `//!name rest`.
fn tag(comment: &str) -> Option<(&str, &str)> {
    let text = comment.trim_start_matches('/').trim().strip_prefix(['\\', '@', '!'])?;
    let (tag, rest) = text.split_once(char::is_whitespace)?;
    tag.starts_with(char::is_alphabetic).then(|| (tag, rest.trim()))
}
