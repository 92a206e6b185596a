//! Marks of merge conflicts that are not resolved.

use memchr::memmem;

/// Starts of a line that marks a conflict. Some names follow: of the branches, or of the files.
const MARKS: [&[u8]; 5] = [b"<<<<<<< ", b">>>>>>> ", b"||||||| ", ESCAPED_OPENING, ESCAPED_END];

/// The first and the last line of a conflict in escaped code.
const ESCAPED_OPENING: &[u8] = b"&lt;&lt;&lt;&lt;&lt;&lt;&lt; ";
const ESCAPED_END: &[u8] = b"&gt;&gt;&gt;&gt;&gt;&gt;&gt; ";

/// Prefix of a comment in which a merge conflict stores the other versions of an element.
pub(crate) const CONFLICT_COMMENT: &str = "<!-- <<<<<<<";

/// Whether a line begins with a mark, other than the line `=======` between the versions, which also underlines titles.
pub(crate) fn is_mark(line: &[u8]) -> bool {
    MARKS.iter().any(|mark| line.starts_with(mark))
}

/// Returns the number of the first line with a mark, from 1; `None` if there is none. The file may be of any kind.
#[must_use]
pub fn conflict_line(bytes: &[u8]) -> Option<usize> {
    let content = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    let has_mark = |line: &[u8]| is_mark(line) || memmem::find(line, CONFLICT_COMMENT.as_bytes()).is_some();
    // Old files separate lines with CR only.
    let has_mark = |line: &[u8]| line.split(|byte| *byte == b'\r').any(has_mark);
    content.split(|byte| *byte == b'\n').position(has_mark).map(|index| index + 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn marks_are_found_in_every_kind_of_file() {
        for (content, line) in [
            (&b"a;b\r\n<<<<<<< ours\r\n1;2\r\n"[..], Some(2)),
            (b"\xef\xbb\xbf<<<<<<< HEAD\n", Some(1)),
            (b"PK\x03\x04\xff\n>>>>>>> theirs\n\0", Some(2)),
            (b"a\r||||||| base\r", Some(1)),
            (b"<a>\n  <!-- <<<<<<< conflict in `x`\n", Some(2)),
            (b"<code>begin\n&lt;&lt;&lt;&lt;&lt;&lt;&lt; HEAD\n", Some(2)),
            (b"Title\n=======\n", None),
            (b"x <<<<<<< y\n<<<<<<<<\n<!-- note -->", None),
            (b"", None),
        ] {
            assert_eq!(conflict_line(content), line, "{}", String::from_utf8_lossy(content));
        }
    }
}
