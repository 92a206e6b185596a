//! A program: its head, and the comment at the start of its code.

use val3_analysis::db::{Db, File, Project};
use val3_analysis::items::parse;
use val3_analysis::items::project::{items, signature};
use val3_analysis::ty::brackets;
use val3_syntax::SyntaxKind;
use val3_syntax::view::View;

use super::fenced;

pub(super) fn hover(db: &dyn Db, project: Project, name: &str) -> Option<String> {
    let file = *items(db, project).programs.get(name)?;
    let mut text = fenced(&line(db, project, file));
    if let Some(comment) = comment(db, file) {
        text.push('\n');
        text.push_str(&comment);
    }
    Some(text)
}

/// `public program pick(num x_n, string& x_s)`
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

/// The comment at the head of a program, before its first statement, as Markdown: `//\brief`, `//\param x what` and
/// the like are taken apart.
pub(crate) fn comment(db: &dyn Db, file: File) -> Option<String> {
    let parse = parse(db, file);
    let code = val3_analysis::items::program::code(View::root(parse.green()))?;
    let mut lines = Vec::new();
    let pieces = code
        .children_with_tokens()
        .skip_while(|piece| piece.as_token().is_none_or(|token| token.kind() != SyntaxKind::BEGIN_KW));
    for piece in pieces.skip(1) {
        let Some(token) = piece.into_token() else { break };
        match token.kind() {
            SyntaxKind::COMMENT => lines.push(comment_line(token.text())),
            SyntaxKind::NEWLINE | SyntaxKind::WHITESPACE => {}
            _ => break,
        }
    }
    let text = lines.join("\n").trim().to_owned();
    (!text.is_empty()).then_some(text)
}

/// The text of a comment. A line of dashes or the like is a rule that somebody drew, and no text.
fn comment_line(comment: &str) -> String {
    let text = comment.trim_start_matches('/').trim();
    if !text.is_empty() && !text.contains(|letter: char| letter.is_alphanumeric()) {
        return String::new();
    }
    match text.strip_prefix(['\\', '@']).and_then(|tag| tag.split_once(char::is_whitespace)) {
        Some(("brief", rest)) => rest.trim().to_owned(),
        Some(("param", rest)) => {
            let (name, about) = rest.trim().split_once(char::is_whitespace).unwrap_or((rest.trim(), ""));
            format!("- `{name}`: {}", about.trim())
        }
        Some((tag, rest)) => format!("- {tag}: {}", rest.trim()),
        None => text.to_owned(),
    }
}
