//! V0112: a name that is not a value.

use val3_analysis::problem::NameKind;

use crate::{diagnostic::Wording, english::a_name_kind, rule::rule};

rule! {
    /// The name of a program, library identifier or type is used as a value.
    ///
    /// ## Why
    /// Only data, local variables, parameters and the results of instructions are values. A program returns no value:
    /// it is called on a line of its own and returns its results through parameters by reference. A library identifier
    /// has no value; it is followed by a colon and the name of an item.
    ///
    /// ## Bad
    /// ```val3
    /// num nTotal
    ///
    /// nTotal=sum
    ///
    /// program sum()
    /// begin
    /// end
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nTotal
    ///
    /// call sum(nTotal)
    ///
    /// program sum(num& x_nTotal)
    /// begin
    ///   x_nTotal=x_nTotal+1
    /// end
    /// ```
    V0112 "not-a-value" Error
}

/// Returns the wording of the finding.
pub(crate) fn word(name: &str, is: NameKind) -> Wording {
    Wording::new(format!("`{name}` is {}, not a value", a_name_kind(is)), "not a value", instead(name, is))
}

/// Advice for a name that is no value.
fn instead(name: &str, is: NameKind) -> String {
    match is {
        NameKind::Program => format!(
            "a call needs round brackets: `{name}(…)`; a program returns results through parameters passed by reference"
        ),
        NameKind::Library => format!("name the data of the library: `{name}:…`"),
        NameKind::Type => "declare data of this type, and use the data".into(),
        NameKind::Instruction => format!("an instruction needs its round brackets: `{name}(…)`"),
        NameKind::Data | NameKind::Local | NameKind::Parameter | NameKind::Field => String::new(),
    }
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn the_message_says_what_is_wrong() {
        expect![[r#"
            `sum` is a program, not a value
            | not a value
            ? a call needs round brackets: `sum(…)`; a program returns results through parameters passed by reference
        "#]]
        .assert_eq(&word("sum", NameKind::Program).to_string());
        expect![[r#"
            `part` is a library identifier, not a value
            | not a value
            ? name the data of the library: `part:…`
        "#]]
        .assert_eq(&word("part", NameKind::Library).to_string());
        expect![[r#"
            `Slot` is a user type, not a value
            | not a value
            ? declare data of this type, and use the data
        "#]]
        .assert_eq(&word("Slot", NameKind::Type).to_string());
        expect![[r#"
            `clock` is an instruction, not a value
            | not a value
            ? an instruction needs its round brackets: `clock(…)`
        "#]]
        .assert_eq(&word("clock", NameKind::Instruction).to_string());
    }
}
