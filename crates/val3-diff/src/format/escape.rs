//! Escaping of text in Markdown and HTML.

/// Escapes text for HTML.
pub(super) fn html(text: &str) -> String {
    let visible = printable(text);
    visible.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// Escapes text for Markdown outside of code.
pub(super) fn markdown(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for character in printable(text).chars() {
        if matches!(
            character,
            '\\' | '`' | '*' | '_' | '{' | '}' | '[' | ']' | '<' | '>' | '#' | '|' | '&' | '~' | '$' | '@'
        ) {
            escaped.push('\\');
        }
        escaped.push(if character == '\n' { ' ' } else { character });
    }
    escaped
}

/// Formats text as a Markdown code span.
pub(super) fn code_span(text: &str) -> String {
    let text = printable(text).replace('\n', " ");
    let longest = text.split(|character| character != '`').map(str::len).max().unwrap_or(0);
    let fence = "`".repeat(longest + 1);
    let blank = if text.starts_with('`') || text.ends_with('`') { " " } else { "" };
    // A bar would end a table cell, even in a code span.
    format!("{fence}{blank}{}{blank}{fence}", text.replace('|', "\\|"))
}

/// Replaces control characters, which could act on a terminal.
pub(super) fn printable(text: &str) -> String {
    text.chars()
        .map(|character| if character.is_control() && !matches!(character, '\n' | '\t') { '?' } else { character })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_cannot_leave_their_place() {
        assert_eq!(html("<script>\"&\u{1b}"), "&lt;script&gt;&quot;&amp;?");
        assert_eq!(markdown("a|b [x](y) @me\nz"), "a\\|b \\[x\\](y) \\@me z");
        assert_eq!(code_span("a`b|c"), "``a`b\\|c``");
        assert_eq!(code_span("`"), "`` ` ``");
    }
}
