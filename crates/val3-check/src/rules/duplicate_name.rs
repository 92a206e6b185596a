//! V0108: a name that is declared twice.

use val3_analysis::problem::NameKind;

use crate::{diagnostic::Wording, phrase::name_kind, rule::rule};

rule! {
    /// A name is declared twice in the same scope.
    ///
    /// ## Why
    /// The name would be ambiguous, and the controller does not load the application. Data of one application have
    /// different names, and so have the programs, and the parameters and local variables of one program together. A
    /// local variable may have the name of data of the application: inside its program it then hides that data.
    ///
    /// ## Bad
    /// ```val3
    /// program pick(num x_nRow)
    ///   num l_nIndex
    ///   num l_nIndex
    /// begin
    ///   l_nIndex=x_nRow
    /// end
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// program pick(num x_nRow)
    ///   num l_nIndex
    /// begin
    ///   l_nIndex=x_nRow
    /// end
    /// ```
    V0108 "duplicate-name" Error
}

/// Returns the wording of the finding.
pub(crate) fn word(name: &str, what: NameKind) -> Wording {
    Wording::new(format!("the {} `{name}` is declared twice", name_kind(what)), "declared again", "")
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn the_message_says_what_is_wrong() {
        expect![[r#"
            the local variable `l_nIndex` is declared twice
            | declared again
        "#]]
        .assert_eq(&word("l_nIndex", NameKind::Local).to_string());
        expect![[r#"
            the data `nCount` is declared twice
            | declared again
        "#]]
        .assert_eq(&word("nCount", NameKind::Data).to_string());
    }
}
