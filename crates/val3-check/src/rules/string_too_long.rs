//! V0223: a text that is too long for a string.

use crate::{diagnostic::Wording, rule::rule};

rule! {
    /// A text between quotes is longer than a `string` can be.
    ///
    /// ## Why
    /// A `string` holds at most 128 bytes (3.4.1). Letters without accents, digits and signs take 1 byte each, accented
    /// and Cyrillic letters 2, Chinese characters 3. The controller does not load an application with a longer text;
    /// two strings joined by `+` are cut at the same limit when the program runs.
    ///
    /// ## Bad
    /// ```val3
    /// putln("The gripper did not report that it holds a part. Check the air pressure, the valve and the sensor of the gripper, then start again.")
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// putln("The gripper did not report that it holds a part.")
    /// putln("Check the air pressure, the valve and the sensor of the gripper, then start again.")
    /// ```
    V0223 "string-too-long" Error
}

/// Returns the wording of the finding.
pub(crate) fn word(bytes: usize) -> Wording {
    let surplus = bytes.saturating_sub(128);
    Wording {
        message: format!("this text has {bytes} bytes; a `string` holds 128"),
        label: format!("{surplus} {} too long", if surplus == 1 { "byte" } else { "bytes" }),
        help: "shorten the text, or write it in two parts; letters beyond English take 2 to 4 bytes".into(),
    }
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::word;

    #[test]
    fn the_message_says_what_is_wrong() {
        expect![[r#"
            this text has 132 bytes; a `string` holds 128
            | 4 bytes too long
            ? shorten the text, or write it in two parts; letters beyond English take 2 to 4 bytes
        "#]]
        .assert_eq(&word(132).to_string());
        assert_eq!(word(129).label, "1 byte too long");
    }
}
