//! V0007: a character that is not allowed in XML.

use crate::{
    diagnostic::{Fix, Wording},
    fix::Site,
    rule::rule,
};

rule! {
    /// A file contains a control character, such as NUL.
    ///
    /// ## Why
    /// The only control characters that XML allows are tab, line feed and carriage return. With any other one the file
    /// is not well-formed, and the controller does not load the application. Such characters come from an interrupted
    /// transfer, a full disk, or text that was copied from a terminal. NUL after every letter means that the file was
    /// saved as UTF-16 without a byte order mark; save it as UTF-8.
    ///
    /// One finding is reported for each line.
    ///
    /// ## Bad
    /// ```text
    /// <Value key="0" value="rea\x00dy" />        a byte of 0 within the text
    /// ```
    ///
    /// ## Good
    /// ```text
    /// <Value key="0" value="ready" />
    /// ```
    V0007 "control-character" Error
}

/// Returns the wording of the finding.
pub(crate) fn word(character: char) -> Wording {
    let name = match character {
        '\0' => ", NUL,",
        '\u{7}' => ", BEL,",
        '\u{8}' => ", backspace,",
        '\u{b}' => ", vertical tab,",
        '\u{c}' => ", form feed,",
        '\u{1b}' => ", escape,",
        _ => "",
    };
    Wording::new(
        format!("the character U+{:04X}{name} is not allowed in an XML file", u32::from(character)),
        "a control character",
        "remove it; it may show that part of the file was lost",
    )
}

/// Removes the characters.
pub(crate) fn fix(site: &Site<'_>) -> Option<Fix> {
    Some(Fix::guess("remove the control characters", vec![site.write(site.range, "")]))
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::testing::check_files;

    #[test]
    fn the_message_says_what_is_wrong() {
        expect![[r#"
            the character U+0000, NUL, is not allowed in an XML file
            | a control character
            ? remove it; it may show that part of the file was lost
        "#]]
        .assert_eq(&word('\0').to_string());
        assert!(word('\u{1}').message.starts_with("the character U+0001 is not allowed"));
    }

    /// Findings in a cell whose program has `line` and whose data has `value`.
    fn codes(line: &str, value: &str) -> Vec<(&'static str, String, usize)> {
        let listing = format!("string sA = \"{value}\"\n{line}");
        let fixture = val3_test::Fixture::parse(&listing);
        let files: Vec<_> = fixture.files.into_iter().map(|(path, text)| (path, text.into_bytes())).collect();
        let found = check_files(&files).into_iter().filter(|found| found.code.starts_with("V0"));
        found.map(|found| (found.code, found.file, found.line)).filter(|found| found.0 < "V0113").collect()
    }

    #[test]
    fn control_characters_are_found_in_code_comments_and_data() {
        assert_eq!(codes("sA=\"x\"", "y"), []);
        for line in ["sA=\"a\0b\"", "cls() // a\u{1}b", "sA\u{c}=\0\"x\""] {
            let found = codes(line, "y");
            assert_eq!(found.len(), 1, "{line:?}: {found:?}");
            assert_eq!((found[0].0, found[0].2), ("V0007", 5), "{line:?}");
        }
        let found = codes("sA=\"x\"", "a\0\0b");
        assert_eq!(found.iter().map(|found| found.0).collect::<Vec<_>>(), ["V0007"]);
    }
}
