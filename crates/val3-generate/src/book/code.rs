//! Colours of VAL 3 code, by the project's lexer, and links from instructions and types in the code.

use std::fmt::Write as _;

use pulldown_cmark::{CodeBlockKind, Event, Parser, Tag, TagEnd};
use val3_check::topics::TopicKind;
use val3_lang::types::BaseType;
use val3_lang::{builtins, enumerations, instructions};
use val3_syntax::{SyntaxKind, SyntaxToken, TextRange, TextSize, parse};

use crate::book::links::{options, replaced};
use crate::book::names::PageNames;
use crate::book::page::BookPage;

/// Replaces blocks of VAL 3 code in a page by HTML. Blocks in lists remain unchanged.
pub(crate) fn coloured(page: &BookPage, names: &PageNames) -> String {
    let mut edits = Vec::new();
    let mut lists = 0_usize;
    let mut block = None;
    for (event, range) in Parser::new_ext(&page.text, options()).into_offset_iter() {
        match event {
            Event::Start(Tag::List(_)) => lists += 1,
            Event::End(TagEnd::List(_)) => lists = lists.saturating_sub(1),
            Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(language))) if lists == 0 => {
                block = is_val3(page, &language).then_some((range, String::new()));
            }
            Event::Text(text) => {
                if let Some((_, code)) = &mut block {
                    code.push_str(&text);
                }
            }
            Event::End(TagEnd::CodeBlock) => {
                edits.extend(block.take().map(|(range, code)| (range, html(page, names, &code))));
            }
            _ => {}
        }
    }
    replaced(&page.text, edits)
}

/// Whether a block is VAL 3 code: it is marked as such, or it contains the forms of an instruction.
fn is_val3(page: &BookPage, language: &str) -> bool {
    let first = language.split_whitespace().next().unwrap_or_default();
    first == "val3" || first.is_empty() && page.kind() == Some(TopicKind::Instruction)
}

fn html(page: &BookPage, names: &PageNames, code: &str) -> String {
    let mut html = String::from("<pre><code class=\"no-highlight hljs\">");
    let mut lines = String::new();
    let mut is_file = false;
    for line in code.split_inclusive('\n') {
        let is_marker = line.starts_with("--- ") || line.starts_with("=== ");
        if is_marker {
            tokens(page, names, &std::mem::take(&mut lines), &mut html);
            is_file = line.starts_with("=== ");
            span(&mut html, "hljs-meta", line);
        } else if is_file {
            html.push_str(&escaped(line));
        } else {
            lines.push_str(line);
        }
    }
    tokens(page, names, &lines, &mut html);
    html.push_str("</code></pre>\n");
    html
}

/// Program file around the code, so that the lexer reads it as code.
const BEFORE: &str = "<Programs><Program name=\"a\"><Code><![CDATA[";
const AFTER: &str = "]]></Code></Program></Programs>";

/// Writes lines of code or declarations.
fn tokens(page: &BookPage, names: &PageNames, code: &str, html: &mut String) {
    let text = format!("{BEFORE}{code}{AFTER}");
    let range = TextRange::at(TextSize::of(BEFORE), TextSize::of(code));
    let tree = parse(&text).root();
    let all = tree.descendants_with_tokens().filter_map(|element| element.into_token());
    for token in all.filter(|token| range.contains_range(token.text_range())) {
        write_token(page, names, &token, html);
    }
}

fn write_token(page: &BookPage, names: &PageNames, token: &SyntaxToken, html: &mut String) {
    let text = token.text();
    match class(token) {
        None => html.push_str(&escaped(text)),
        Some(TokenClass::Plain(class)) => span(html, class, text),
        Some(TokenClass::Page(kind, class)) => match names.of_kind(kind, text).filter(|path| *path != page.path) {
            Some(path) => {
                let address = page.link_to(&path.replace(".md", ".html"));
                let _ = write!(html, "<a class=\"{class}\" href=\"{address}\">{}</a>", escaped(text));
            }
            None => span(html, class, text),
        },
    }
}

/// Colour of a token, with the kind of page to which it links.
enum TokenClass {
    Plain(&'static str),
    Page(TopicKind, &'static str),
}

fn class(token: &SyntaxToken) -> Option<TokenClass> {
    let text = token.text();
    match token.kind() {
        SyntaxKind::COMMENT => Some(TokenClass::Plain("hljs-comment")),
        SyntaxKind::STRING => Some(TokenClass::Plain("hljs-string")),
        SyntaxKind::NUMBER => Some(TokenClass::Plain("hljs-number")),
        kind if kind.is_keyword() => Some(TokenClass::Plain("hljs-keyword")),
        SyntaxKind::IDENT => word(token, text),
        _ => None,
    }
}

/// Words at the beginning of a declaration in a listing.
const LISTING: [&str; 6] = ["public", "private", "program", "library", "type", "version"];

fn word(token: &SyntaxToken, text: &str) -> Option<TokenClass> {
    let neighbour = |token: Option<SyntaxToken>| token.map(|token| token.kind());
    let is_called = neighbour(token.next_token()) == Some(SyntaxKind::L_PAREN);
    let is_field = neighbour(token.prev_token()) == Some(SyntaxKind::DOT);
    if is_field {
        None
    } else if is_called && instructions::find(text).is_some() {
        Some(TokenClass::Page(TopicKind::Instruction, "hljs-built_in"))
    } else if neighbour(token.prev_token()) == Some(SyntaxKind::EQ) && enumerations::find(text).is_some() {
        Some(TokenClass::Plain("hljs-literal"))
    } else if BaseType::from_name(text).is_some() {
        Some(TokenClass::Page(TopicKind::Type, "hljs-type"))
    } else if enumerations::find(text).is_some() || builtins::find(text).is_some() {
        Some(TokenClass::Plain("hljs-literal"))
    } else if LISTING.contains(&text) {
        Some(TokenClass::Plain("hljs-keyword"))
    } else {
        None
    }
}

fn span(html: &mut String, class: &str, text: &str) {
    let _ = write!(html, "<span class=\"{class}\">{}</span>", escaped(text));
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn coloured_text(text: &str) -> String {
        coloured(&BookPage::plain("a/b.md", text), &PageNames::new(&[]))
    }

    #[test]
    fn code_has_colours_and_links() {
        let text = coloured_text(
            "One\n```val3\npoint pA\n  if pA.config.wrist==wfree // no\n    movej(pA,flange,\"x\")\n```\nTwo\n",
        );
        assert!(text.starts_with("One\n<pre><code class=\"no-highlight hljs\"><a class=\"hljs-type\" href=\"../types/point.html\">point</a> pA"), "{text}");
        for part in [
            "<span class=\"hljs-keyword\">if</span> pA.config.wrist==<span class=\"hljs-literal\">wfree</span>",
            "<a class=\"hljs-built_in\" href=\"../instructions/movej.html\">movej</a>(pA,<span class=\"hljs-literal\">flange</span>,",
            "<span class=\"hljs-string\">&quot;x&quot;</span>)\n</code></pre>\n",
        ] {
            assert!(text.contains(part), "{text}");
        }
        assert!(text.ends_with("Two\n"), "{text}");
    }

    #[test]
    fn files_in_listings_have_no_colours() {
        let text = coloured_text("```val3\n=== main/main.dtx\n<Data>if</Data>\n--- part\nnum n\n```\n");
        assert!(
            text.contains(
                "=== main/main.dtx\n</span>&lt;Data&gt;if&lt;/Data&gt;\n<span class=\"hljs-meta\">--- part\n</span><a"
            ),
            "{text}"
        );
    }

    #[test]
    fn every_character_of_an_example_is_kept() {
        let code = "num nA[2,\"x\"]\nbegin\n\n\tnA=1-+*$^é & < >\n  x.y=\"a\n";
        let html = coloured_text(&format!("```val3\n{code}```\n"));
        let mut plain = String::new();
        let mut in_tag = false;
        for letter in html.chars() {
            match letter {
                '<' => in_tag = true,
                '>' => in_tag = false,
                letter if !in_tag => plain.push(letter),
                _ => {}
            }
        }
        assert_eq!(plain.trim_end(), escaped(code).trim_end());
    }
}
