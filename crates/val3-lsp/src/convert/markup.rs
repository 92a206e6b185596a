//! Texts in Markdown, for clients that show it and those that do not.

use tower_lsp::lsp_types::{Documentation, MarkupContent, MarkupKind};

use crate::session::TextFormat;

/// A text in Markdown, as such or without its marks.
pub(crate) fn markup(format: TextFormat, text: String) -> MarkupContent {
    match format {
        TextFormat::Markdown => MarkupContent { kind: MarkupKind::Markdown, value: text },
        TextFormat::PlainMarkup | TextFormat::Plain => {
            MarkupContent { kind: MarkupKind::PlainText, value: plain(&text) }
        }
    }
}

/// As [`markup`], where the protocol also allows a plain string.
pub(crate) fn documentation(format: TextFormat, text: String) -> Documentation {
    match format {
        TextFormat::Plain => Documentation::String(plain(&text)),
        TextFormat::Markdown | TextFormat::PlainMarkup => Documentation::MarkupContent(markup(format, text)),
    }
}

/// The text without the marks of headings, code and emphasis. Code stays to the letter.
fn plain(markdown: &str) -> String {
    let mut in_code = false;
    let mut lines: Vec<String> = Vec::new();
    for line in markdown.lines() {
        if line.trim_start().starts_with("```") {
            in_code = !in_code;
        } else if in_code {
            lines.push(line.to_owned());
        } else {
            lines.push(unmarked(line));
        }
    }
    lines.join("\n").trim().to_owned()
}

fn unmarked(line: &str) -> String {
    let text = line.trim_start_matches('#');
    let text = if text.len() < line.len() { text.trim_start() } else { line };
    // Text between backticks is code.
    let parts = text.split('`').enumerate();
    parts.map(|(at, part)| if at % 2 == 1 { part.to_owned() } else { part.replace("**", "") }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn markdown_becomes_plain_text() {
        let text = "## Title\n\n```val3\nnA = nB ** 2 // `x`\n```\n\nThe **first** of `a**b`.\n---\n- one";
        let plain = "Title\n\nnA = nB ** 2 // `x`\n\nThe first of a**b.\n---\n- one";
        let shown = markup(TextFormat::PlainMarkup, text.to_owned());
        assert_eq!((shown.kind, shown.value.as_str()), (MarkupKind::PlainText, plain));
        assert_eq!(markup(TextFormat::Markdown, text.to_owned()).value, text);
        assert_eq!(documentation(TextFormat::Plain, text.to_owned()), Documentation::String(plain.to_owned()));
    }
}
