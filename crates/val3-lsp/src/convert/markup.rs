//! Markdown text for clients with and without Markdown support.

use tower_lsp::lsp_types::{Documentation, MarkupContent, MarkupKind};
use val3_syntax::TextSlice;

use crate::session::TextFormat;

/// Text as Markdown, or as plain text without markup.
pub(crate) fn markup(format: TextFormat, text: String) -> MarkupContent {
    match format {
        TextFormat::Markdown => MarkupContent { kind: MarkupKind::Markdown, value: text },
        TextFormat::PlainMarkup | TextFormat::Plain => {
            MarkupContent { kind: MarkupKind::PlainText, value: plain(&text) }
        }
    }
}

/// Like [`markup`], for fields in which the protocol also accepts a plain string.
pub(crate) fn documentation(format: TextFormat, text: String) -> Documentation {
    match format {
        TextFormat::Plain => Documentation::String(plain(&text)),
        TextFormat::Markdown | TextFormat::PlainMarkup => Documentation::MarkupContent(markup(format, text)),
    }
}

/// Removes the markup of headings, code and emphasis. Code is unchanged.
fn plain(markdown: &str) -> String {
    // Fence that ends the current code block.
    let mut fence: Option<&str> = None;
    let mut lines: Vec<String> = Vec::new();
    for line in markdown.lines() {
        match fence {
            Some(end) if line.trim() == end => fence = None,
            Some(_) => lines.push(line.to_owned()),
            None => match fence_of(line) {
                Some(start) => fence = Some(start),
                None => lines.push(unmarked(line)),
            },
        }
    }
    lines.join("\n").trim().to_owned()
}

/// Backticks with which a line opens a code block.
fn fence_of(line: &str) -> Option<&str> {
    let line = line.trim_start();
    let marks = line.find(|letter| letter != '`').unwrap_or(line.len());
    line.get(..marks).filter(|_| marks >= 3)
}

fn unmarked(line: &str) -> String {
    let text = line.trim_start_matches('#');
    let mut rest = if text.len() < line.len() { text.trim_start() } else { line };
    let mut shown = String::with_capacity(rest.len());
    while let Some(letter) = rest.chars().next() {
        if let Some((code, after)) = code_span(rest) {
            shown.push_str(code);
            rest = after;
        } else if let Some(after) = rest.strip_prefix("**") {
            rest = after;
        } else {
            let escaped = rest.strip_prefix('\\').and_then(first).filter(|(letter, _)| letter.is_ascii_punctuation());
            let (letter, after) = escaped.unwrap_or_else(|| (letter, rest.part(letter.len_utf8()..)));
            shown.push(letter);
            rest = after;
        }
    }
    shown
}

fn first(text: &str) -> Option<(char, &str)> {
    let mut letters = text.chars();
    letters.next().map(|letter| (letter, letters.as_str()))
}

/// Code between the backticks at the start of `text`, and the text after the code span.
fn code_span(text: &str) -> Option<(&str, &str)> {
    let marks = text.find(|letter| letter != '`').unwrap_or(text.len());
    let (fence, inside) = text.split_at_checked(marks).filter(|(fence, _)| !fence.is_empty())?;
    let mut from = 0;
    loop {
        let start = from + inside.get(from..)?.find(fence)?;
        let run = inside.get(start..)?.bytes().take_while(|byte| *byte == b'`').count();
        if run == marks {
            let code = inside.get(..start)?;
            let is_padded = code.starts_with(' ') && code.ends_with(' ') && !code.trim().is_empty();
            let code = if is_padded { code.get(1..start - 1)? } else { code };
            return Some((code, inside.get(start + run..)?));
        }
        from = start + run;
    }
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

    #[test]
    fn escaped_text_is_shown_to_the_letter() {
        let shown = |text: &str| markup(TextFormat::PlainMarkup, text.to_owned()).value;
        assert_eq!(
            shown(r"\- \<value\> of x\_n \* 2, \![t\](https\://host)"),
            "- <value> of x_n * 2, ![t](https://host)"
        );
        assert_eq!(shown(r"``a`b`` and `` ` `` of C:\dir \\"), r"a`b and ` of C:\dir \");
        assert_eq!(shown("````val3\n```\n![t](x)\n````\nend"), "```\n![t](x)\nend");
        assert_eq!(shown("one ` alone"), "one ` alone");
    }
}
