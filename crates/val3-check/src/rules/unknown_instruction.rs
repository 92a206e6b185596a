//! V0103: a call to an instruction that VAL 3 does not have.

use val3_analysis::problem::NameKind;

use val3_syntax::TextRange;

use crate::{
    diagnostic::{Fix, Wording},
    english::{a_name_kind, meant},
    fix::{Site, rename},
    rule::rule,
};

rule! {
    /// The name before round brackets is not an instruction of VAL 3.
    ///
    /// ## Why
    /// A name followed by round brackets is an instruction, unless `call` precedes it. Programs of the application are
    /// called with `call`, and indexes of an array are written in square brackets. Letter case matters: `movej`, not
    /// `moveJ`. The controller does not load an application with an unknown instruction.
    ///
    /// ## Bad
    /// ```val3
    /// joint jHome
    /// mdesc mFast
    ///
    /// moveJ(jHome,flange,mFast)
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// joint jHome
    /// mdesc mFast
    ///
    /// movej(jHome,flange,mFast)
    /// ```
    V0103 "unknown-instruction" Error
}

/// Returns the wording of the finding.
pub(crate) fn word(name: &str, near: Option<&str>, is: Option<NameKind>) -> Wording {
    match is {
        Some(is) => Wording::new(
            format!("`{name}` is {}, not an instruction", a_name_kind(is)),
            "not an instruction",
            instead(name, is),
        ),
        None => {
            Wording::new(format!("VAL 3 has no instruction `{name}`"), "no such instruction", meant(name, near, ""))
        }
    }
}

/// Advice for a name that is no instruction.
fn instead(name: &str, is: NameKind) -> String {
    match is {
        NameKind::Program => format!("a program is called with `call`: `call {name}(…)`"),
        NameKind::Data | NameKind::Local | NameKind::Parameter => {
            format!("an index or key is written in square brackets: `{name}[…]`")
        }
        NameKind::Library => format!("name the program of the library: `call {name}:…()`"),
        NameKind::Type => "a value of a type is written between braces: `{…}`".into(),
        NameKind::Instruction | NameKind::Field => String::new(),
    }
}

/// Writes the similar name, or `call` before a program. In a library only a program is possible.
pub(crate) fn fix(site: &Site<'_>, name: &str, near: Option<&str>, is: Option<NameKind>) -> Option<Fix> {
    if is != Some(NameKind::Program) && !name.contains(':') {
        return rename(site, name, near);
    }
    let starts_line = site.before().trim().is_empty();
    let edit = site.replace(TextRange::empty(site.range.start()), "call ");
    starts_line.then(|| Fix::safe("write `call`", vec![edit]))
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn the_help_proposes_a_similar_instruction() {
        expect![[r#"
            VAL 3 has no instruction `moveJ`
            | no such instruction
            ? did you mean `movej`? Names are case-sensitive
        "#]]
        .assert_eq(&word("moveJ", Some("movej"), None).to_string());
        expect![[r#"
            VAL 3 has no instruction `printf`
            | no such instruction
            ? `putln(…)` writes on the user page, and `?` on the console
        "#]]
        .assert_eq(&word("printf", None, None).to_string());
    }

    /// The similar instruction does something different.
    #[test]
    fn a_name_of_another_language_is_no_misspelling() {
        let similar =
            [("setDI", "setDH"), ("sign", "sin"), ("sinh", "sin"), ("set", "get"), ("on", "ln"), ("jog", "log")];
        for (name, near) in similar {
            let help = word(name, Some(near), None).help;
            assert!(!help.is_empty() && !help.contains(near), "{name}: {help}");
        }
    }

    #[test]
    fn other_callees_are_described() {
        expect![[r#"
            `pick` is a program, not an instruction
            | not an instruction
            ? a program is called with `call`: `call pick(…)`
        "#]]
        .assert_eq(&word("pick", None, Some(NameKind::Program)).to_string());
        expect![[r#"
            `nData` is data, not an instruction
            | not an instruction
            ? an index or key is written in square brackets: `nData[…]`
        "#]]
        .assert_eq(&word("nData", None, Some(NameKind::Data)).to_string());
    }
}
