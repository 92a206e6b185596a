//! Formats code without XML, from `begin` to `end`, as copied from an editor or a chat.

use val3_fmt::CodeStyle;
use val3_syntax::xml::escaped;
use val3_syntax::{TextEdit, decode_entities};

/// XML that encloses code of the old dialect, in which code may contain any character.
const HEAD: &str = "<programList xmlns=\"ProgramNameSpace\"><program name=\"program\"><source><code>";
const TAIL: &str = "</code></source></program></programList>";
/// Byte order mark.
const MARK: char = '\u{feff}';

/// Whether the text is code without XML.
pub(super) fn is_bare(text: &str) -> bool {
    !text.trim_start_matches(MARK).trim_start().starts_with('<')
}

/// Formats the code. The second value is whether a part was skipped because of syntax errors. `None` if the code does
/// not begin with `begin`.
pub(super) fn format(text: &str, style: &CodeStyle) -> Option<(String, bool)> {
    let code = text.trim_start_matches(MARK).trim_start();
    if !begins(code) {
        return None;
    }
    let wrapped = [HEAD, &escaped(code), TAIL].concat();
    let parse = val3_syntax::parse(&wrapped);
    let formatted = TextEdit::apply_all(&wrapped, &val3_fmt::format(&wrapped, &parse, style));
    let code = formatted.strip_prefix(HEAD)?.strip_suffix(TAIL)?;
    Some((decode_entities(code).into_owned(), !parse.errors().is_empty()))
}

/// Whether the first word is `begin`.
fn begins(code: &str) -> bool {
    let word = code.split(|letter: char| !letter.is_alphanumeric() && letter != '_').next().unwrap_or("");
    word.eq_ignore_ascii_case("begin")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn formatted(text: &str) -> Option<(String, bool)> {
        format(text, &CodeStyle::default())
    }

    #[test]
    fn code_gets_its_layout() {
        let code = "\n  BEGIN\r\nif a[b[1]]>2 and c<\"&lt;\"\r\n// \u{4e2d}\r\nx = 1\r\nendif\r\nend\r\n";
        let expected = "begin\r\n  if a[b[1]]>2 and c<\"&lt;\"\r\n    // \u{4e2d}\r\n    x=1\r\n  endIf\r\nend\r\n";
        assert!(is_bare(code));
        assert_eq!(formatted(code), Some((expected.to_owned(), false)));
        assert_eq!(formatted(expected), Some((expected.to_owned(), false)));
    }

    #[test]
    fn code_with_syntax_errors_is_reported() {
        assert_eq!(formatted("begin\na = = 1\nb = 1\nend"), Some(("begin\na = = 1\n  b=1\nend".to_owned(), true)));
    }

    #[test]
    fn text_that_is_no_program_is_refused() {
        for text in ["", "x = 1\n", "beginning\nend", "# A file\n"] {
            assert!(is_bare(text));
            assert_eq!(formatted(text), None, "{text}");
        }
        assert!(!is_bare("\u{feff} <?xml version=\"1.0\"?>"));
    }
}
