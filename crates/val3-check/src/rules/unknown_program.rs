//! V0102: a call to a name that is no program.

use val3_analysis::problem::NameKind;

use val3_syntax::{TextRange, TextSize};

use crate::{
    diagnostic::{Fix, Wording},
    english::{a_name_kind, meant},
    fix::{Site, rename},
    rule::rule,
};

rule! {
    /// The application does not have the program that is called.
    ///
    /// ## Why
    /// `call`, `taskCreate` and `taskCreateSync` start a program of the application. A program belongs to the
    /// application if the project file lists its file; a file that is only in the folder does not count. Letter case
    /// matters. The name of a program of a library is preceded by its library identifier: `call part:pick()`.
    /// Instructions of VAL 3 are written without `call`.
    ///
    /// ## Bad
    /// ```val3
    /// call pikc()
    ///
    /// program pick()
    /// begin
    /// end
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// call pick()
    ///
    /// program pick()
    /// begin
    /// end
    /// ```
    V0102 "unknown-program" Error
}

/// Returns the wording of the finding.
pub(crate) fn word(name: &str, near: Option<&str>, is: Option<NameKind>) -> Wording {
    match is {
        Some(is) => {
            Wording::new(format!("`{name}` is {}, not a program", a_name_kind(is)), "not a program", instead(name, is))
        }
        None => Wording::new(
            format!("the application has no program `{name}`"),
            "no such program",
            meant(name, near, "write the program, or add its file to the project"),
        ),
    }
}

/// Advice for a name that is no program.
fn instead(name: &str, is: NameKind) -> String {
    match is {
        NameKind::Instruction => format!("an instruction is written without `call`: `{name}(…)`"),
        NameKind::Library => format!("name the program of the library: `call {name}:…()`"),
        _ => String::new(),
    }
}

/// Writes the similar name, or removes `call` before an instruction.
pub(crate) fn fix(site: &Site<'_>, name: &str, near: Option<&str>, is: Option<NameKind>) -> Option<Fix> {
    if is != Some(NameKind::Instruction) {
        return rename(site, name, near);
    }
    let before = site.before().trim_end();
    let keyword = before.len().checked_sub("call".len()).and_then(|at| before.get(at..))?;
    let len = TextSize::of(site.before()) - TextSize::of(before) + TextSize::of(keyword);
    let call = TextRange::new(site.range.start() - len, site.range.start());
    keyword.eq_ignore_ascii_case("call").then(|| Fix::safe("remove `call`", vec![site.replace(call, "")]))
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn the_help_proposes_a_similar_program() {
        expect![[r#"
            the application has no program `pikc`
            | no such program
            ? did you mean `pick`?
        "#]]
        .assert_eq(&word("pikc", Some("pick"), None).to_string());
        expect![[r#"
            the application has no program `vision`
            | no such program
            ? write the program, or add its file to the project
        "#]]
        .assert_eq(&word("vision", None, None).to_string());
    }

    #[test]
    fn other_callees_are_described() {
        expect![[r#"
            `waitEndMove` is an instruction, not a program
            | not a program
            ? an instruction is written without `call`: `waitEndMove(…)`
        "#]]
        .assert_eq(&word("waitEndMove", None, Some(NameKind::Instruction)).to_string());
        expect![[r#"
            `part` is a library identifier, not a program
            | not a program
            ? name the program of the library: `call part:…()`
        "#]]
        .assert_eq(&word("part", None, Some(NameKind::Library)).to_string());
        expect![[r#"
            `nCount` is data, not a program
            | not a program
        "#]]
        .assert_eq(&word("nCount", None, Some(NameKind::Data)).to_string());
    }
}
