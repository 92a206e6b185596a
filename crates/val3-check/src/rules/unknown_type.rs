//! V0106: a type that does not exist.

use crate::{diagnostic::Wording, english::meant, rule::rule};

rule! {
    /// Data, a local variable or a parameter has a type that does not exist.
    ///
    /// ## Why
    /// A type is a built-in type of VAL 3, or a user type that the project file names in `<Types>` (7.2). A project
    /// names every user type that it declares data of, even if a library names the same type. The controller does not
    /// load an application with a type that it does not know.
    ///
    /// ## Bad
    /// ```val3
    /// type Slot "Disk://Slot/Slot.pjx"
    ///
    /// private Slto tFirst
    ///
    /// --- Slot
    /// public num nRow
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// type Slot "Disk://Slot/Slot.pjx"
    ///
    /// private Slot tFirst
    ///
    /// --- Slot
    /// public num nRow
    /// ```
    V0106 "unknown-type" Error
}

/// Returns the wording of the finding.
pub(crate) fn word(name: &str, near: Option<&str>) -> Wording {
    Wording::new(
        format!("`{name}` is neither a type of VAL 3 nor a user type of this project"),
        "no such type",
        meant(name, near, "add the user type to `<Types>` of the project file"),
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::word;

    #[test]
    fn the_message_says_what_is_wrong() {
        expect![[r#"
            `Slto` is neither a type of VAL 3 nor a user type of this project
            | no such type
            ? did you mean `Slot`?
        "#]]
        .assert_eq(&word("Slto", Some("Slot")).to_string());
        expect![[r#"
            `Pallet` is neither a type of VAL 3 nor a user type of this project
            | no such type
            ? add the user type to `<Types>` of the project file
        "#]]
        .assert_eq(&word("Pallet", None).to_string());
    }
}
