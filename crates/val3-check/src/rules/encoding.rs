//! V0005: bytes outside the declared encoding.

use crate::{diagnostic::Wording, rule::rule};

rule! {
    /// A file holds bytes that are not possible in the encoding it declares.
    ///
    /// ## Why
    /// The first line of a file names its encoding; without one, XML means UTF-8. Whoever
    /// reads bytes that the encoding does not have must guess: a text on the pendant comes out wrong, or
    /// the file is not read at all. It happens when an editor saves a file as Windows-1252 or ISO-8859-1
    /// and leaves `encoding="utf-8"` in its first line.
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

/// Words the finding.
pub(crate) fn word() -> Wording {
    Wording::new(
        "the file is not in UTF-8 and does not declare ISO-8859-1 either",
        "read as ISO-8859-1",
        "save the file as UTF-8, or declare `encoding=\"iso-8859-1\"` in its first line",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn bytes_that_are_no_text() {
        expect![[r#"
            the file is not in UTF-8 and does not declare ISO-8859-1 either
            | read as ISO-8859-1
            ? save the file as UTF-8, or declare `encoding="iso-8859-1"` in its first line
        "#]]
        .assert_eq(&word().to_string());
    }
}
