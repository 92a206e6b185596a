//! V0101: a name that is not declared.

use crate::{diagnostic::Wording, english::meant, rule::rule};

rule! {
    /// A name is used that is not declared.
    ///
    /// ## Why
    /// A name in code means a local variable or a parameter of the program, data of the application, or one of the
    /// names that VAL 3 provides, such as `world`, `flange` or `lefty` (2.5.2). Letter case matters. The name of data
    /// of a library is preceded by its library identifier: `part:nWeight`. The controller does not load an application
    /// whose code has any other name.
    ///
    /// ## Bad
    /// ```val3
    /// num nCount
    ///
    /// nCuont=nCount+1
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nCount
    ///
    /// nCount=nCount+1
    /// ```
    V0101 "unknown-name" Error
}

/// Returns the wording of the finding.
pub(crate) fn word(name: &str, near: Option<&str>) -> Wording {
    Wording::new(
        format!("`{name}` is not declared: no local variable, parameter or data has this name"),
        "unknown name",
        meant(name, near, "declare it, or write `identifier:` in front of data of a library"),
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::word;

    #[test]
    fn the_message_says_what_is_wrong() {
        expect![[r#"
            `nCuont` is not declared: no local variable, parameter or data has this name
            | unknown name
            ? did you mean `nCount`?
        "#]]
        .assert_eq(&word("nCuont", Some("nCount")).to_string());
        expect![[r#"
            `nSpeed` is not declared: no local variable, parameter or data has this name
            | unknown name
            ? declare it, or write `identifier:` in front of data of a library
        "#]]
        .assert_eq(&word("nSpeed", None).to_string());
    }
}
