//! Columns of a statement in its file, so that clients mark the statement and not its indentation or XML tags.

use std::ops::Range;

/// Columns of a statement in its line, from 1, in UTF-16 code units.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Columns {
    /// Column of the first character.
    pub(crate) first: u32,
    /// Column after the last character in this line.
    pub(crate) end: u32,
}

impl Columns {
    /// Returns the columns of the bytes `code` in a row of the text, from 1. `None` if the row does not contain them,
    /// because the file has changed since the application was opened.
    ///
    /// Only a tag, blanks and a keyword such as `until` can precede the bytes in the row. The keyword is a part of the
    /// statement.
    pub(crate) fn of(text: &str, row: u32, code: Range<u32>) -> Option<Self> {
        let (start, end) = (usize::try_from(code.start).ok()?, usize::try_from(code.end).ok()?);
        let (before, rest) = (text.get(..start)?, text.get(start..end)?);
        let rows_before = before.bytes().filter(|byte| *byte == b'\n').count();
        if u32::try_from(rows_before + 1).ok()? != row || rest.is_empty() {
            return None;
        }
        let line = before.rsplit('\n').next()?.trim_start_matches('\u{feff}');
        let tag = line.rfind(['>', '[']).map_or(0, |at| at + 1);
        let (tag, own) = line.split_at_checked(tag)?;
        let indentation = own.len() - own.trim_start().len();
        let first = units(tag) + units(own.get(..indentation)?) + 1;
        let end = units(line) + units(rest.lines().next()?.trim_end()) + 1;
        Some(Self { first, end })
    }
}

/// Returns the length of a text in UTF-16 code units.
fn units(text: &str) -> u32 {
    u32::try_from(text.encode_utf16().count()).unwrap_or(u32::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns the columns of `code` in a text, and the text between them.
    fn columns(text: &str, code: &str, row: u32) -> Option<(u32, String)> {
        let at = u32::try_from(text.find(code).unwrap()).unwrap();
        let Columns { first, end } = Columns::of(text, row, at..at + u32::try_from(code.len()).unwrap())?;
        let line: Vec<u16> = text.lines().nth(row as usize - 1)?.encode_utf16().collect();
        Some((first, String::from_utf16(&line[first as usize - 1..end as usize - 1]).unwrap()))
    }

    #[test]
    fn columns_enclose_the_statement_without_tags_and_blanks() {
        for (text, code, row, expected) in [
            ("begin\n  nA=1\nend", "nA=1", 2, Some((3, "nA=1"))),
            ("begin\r\n\tnA=1\r\nend", "nA=1", 2, Some((2, "nA=1"))),
            ("<Code><![CDATA[  nA=1\n", "nA=1", 1, Some((18, "nA=1"))),
            ("<Code>end</Code>", "end", 1, Some((7, "end"))),
            ("  until nA==1\n", "nA==1", 1, Some((3, "until nA==1"))),
            (
                "<!-- \u{1f916} --> putln(\"ü\u{1f916}\")\n",
                "putln(\"ü\u{1f916}\")",
                1,
                Some((13, "putln(\"ü\u{1f916}\")")),
            ),
            ("  call sub(nA,\n    nB)\n", "call sub(nA,\n    nB)", 1, Some((3, "call sub(nA,"))),
        ] {
            assert_eq!(columns(text, code, row), expected.map(|(first, code)| (first, code.to_owned())), "{text}");
        }
    }

    #[test]
    fn a_changed_file_has_no_columns() {
        let text = "a\nb\nnA=1\n";
        assert_eq!(columns(text, "nA=1", 2), None);
        assert_eq!(Columns::of(text, 3, 4..400), None);
        assert_eq!(Columns::of("ü", 1, 1..2), None);
        assert_eq!(Columns::of(text, 1, 0..0), None);
    }
}
