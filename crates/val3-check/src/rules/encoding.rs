//! V0005: bytes outside the declared encoding, and characters lost in a conversion.

use val3_analysis::problem::EncodingFault;

use crate::{diagnostic::Wording, rule::rule};

rule! {
    /// A file is not in the encoding that it declares, or was opened in a different encoding.
    ///
    /// ## Why
    /// The first line of a file names its encoding. Without a declaration, XML uses UTF-8. A reader must guess the
    /// meaning of bytes that the encoding does not have: a text on the pendant is wrong, or the file is not read at
    /// all. This happens when an editor saves a file as Windows-1252 or ISO-8859-1 but leaves `encoding="utf-8"` in its
    /// first line, or saves a program of s5 as UTF-8 but leaves `encoding="iso-8859-1"`. UTF-8, ISO-8859-1 and
    /// Windows-1252 are read as declared; characters beyond ASCII in other encodings are reported.
    ///
    /// An editor that opens an ISO-8859-1 file as UTF-8 shows the character U+FFFD in place of each character beyond
    /// ASCII. Saving the file stores U+FFFD, and the original characters are lost. Close the file without saving, and
    /// open it again in its own encoding.
    ///
    /// ## Bad
    /// ```text
    /// <?xml version="1.0" encoding="utf-8"?>
    /// …
    /// value="Pi\xE8ce"        `è` as the single byte E8 of ISO-8859-1, which UTF-8 does not have
    /// ```
    ///
    /// ## Good
    /// ```text
    /// <?xml version="1.0" encoding="utf-8"?>
    /// …
    /// value="Pi\xC3\xA8ce"    `è` as the two bytes C3 A8 of UTF-8
    /// ```
    V0005 "encoding" Warning
}

/// Returns the wording of the finding.
pub(crate) fn word(fault: EncodingFault) -> Wording {
    match fault {
        EncodingFault::NotUtf8 => Wording::new(
            "the file is not in UTF-8 and declares no other encoding",
            "read as ISO-8859-1",
            "save the file as UTF-8, or declare `encoding=\"iso-8859-1\"` in its first line",
        ),
        EncodingFault::StoredAsUtf8(encoding) => Wording::new(
            format!("the file declares {} and is stored as UTF-8", encoding.name()),
            format!("read as {}, this is not the character that was written", encoding.name()),
            format!("save the file as {}", encoding.name()),
        ),
        EncodingFault::Unsupported(encoding) => Wording::new(
            "the first line of the file declares an encoding that is not supported",
            format!("read as {}, this may be another character", encoding.name()),
            "save the file as UTF-8 and declare `encoding=\"utf-8\"`; ISO-8859-1 and Windows-1252 are read too",
        ),
        EncodingFault::Misread(encoding) => Wording::new(
            format!(
                "the file is stored as {} and is open in another encoding: saving it destroys its special characters",
                encoding.name()
            ),
            "a character that the editor could not read",
            format!("close the file without saving, and open it again as {}", encoding.name()),
        ),
        EncodingFault::Lost => Wording::new(
            "a character was lost when the file was saved in another encoding: U+FFFD is in its place",
            "this was another character",
            "write the character again, or restore the file from a copy",
        ),
    }
}

#[cfg(test)]
mod tests {
    use expect_test::expect;
    use val3_syntax::encoding::Encoding;

    use super::*;

    #[test]
    fn each_encoding_fault_has_its_message() {
        let faults = [
            EncodingFault::NotUtf8,
            EncodingFault::StoredAsUtf8(Encoding::Windows1252),
            EncodingFault::Unsupported(Encoding::Latin1),
            EncodingFault::Misread(Encoding::Latin1),
            EncodingFault::Lost,
        ];
        let words: String = faults.into_iter().map(|fault| word(fault).to_string()).collect();
        expect![[r#"
            the file is not in UTF-8 and declares no other encoding
            | read as ISO-8859-1
            ? save the file as UTF-8, or declare `encoding="iso-8859-1"` in its first line
            the file declares Windows-1252 and is stored as UTF-8
            | read as Windows-1252, this is not the character that was written
            ? save the file as Windows-1252
            the first line of the file declares an encoding that is not supported
            | read as ISO-8859-1, this may be another character
            ? save the file as UTF-8 and declare `encoding="utf-8"`; ISO-8859-1 and Windows-1252 are read too
            the file is stored as ISO-8859-1 and is open in another encoding: saving it destroys its special characters
            | a character that the editor could not read
            ? close the file without saving, and open it again as ISO-8859-1
            a character was lost when the file was saved in another encoding: U+FFFD is in its place
            | this was another character
            ? write the character again, or restore the file from a copy
        "#]]
        .assert_eq(&words);
    }
}
