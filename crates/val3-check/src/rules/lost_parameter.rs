//! V0124: a parameter by value that is written but never read.

use val3_analysis::items::declarations::{Declared, all_params};

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// A program writes a parameter that is passed by value, but never reads it.
    ///
    /// ## Why
    /// A parameter by value is a copy. The written value is lost when the program ends, and the caller never gets it. A
    /// result is returned through a parameter by reference.
    ///
    /// ## Bad
    /// ```val3
    /// num nMean
    /// call mean(2,3,nMean)
    /// putln(nMean)
    ///
    /// program mean(num x_nA, num x_nB, num x_nMean)
    /// begin
    ///   x_nMean=(x_nA+x_nB)/2
    /// end
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nMean
    /// call mean(2,3,nMean)
    /// putln(nMean)
    ///
    /// program mean(num x_nA, num x_nB, num& x_nMean)
    /// begin
    ///   x_nMean=(x_nA+x_nB)/2
    /// end
    /// ```
    V0124 "lost-parameter" Warning, Program: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    if program.header.params.iter().all(|param| param.by_reference) {
        return;
    }
    let used = &program.variable_use().params;
    let is_lost = |name: &str| used.get(name).is_some_and(|uses| uses.written && !uses.may_read());
    if !used.keys().any(|name| is_lost(name)) {
        return;
    }
    let by_value = |name: &str| program.header.params.iter().any(|param| param.name == name && !param.by_reference);
    for Declared { name, range, .. } in all_params(program.db, program.file) {
        if is_lost(&name) && by_value(&name) && !program.is_linkable(&name) {
            found.report(&RULE, range, word(&name));
        }
    }
}

fn word(name: &str) -> Wording {
    Wording::new(
        format!("the value that the program writes to `{name}` never reaches the caller"),
        "taken by value",
        "take the parameter by reference",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    #[test]
    fn a_result_in_a_value_parameter_is_reported() {
        expect![[r#"
            p.pgx:5 `x_nA` the value that the program writes to `x_nA` never reaches the caller
              | taken by value
              ? take the parameter by reference
            p.pgx:6 `x_trB` the value that the program writes to `x_trB` never reaches the caller
              | taken by value
              ? take the parameter by reference
        "#]]
        .assert_eq(&check(&RULE, "program p(num x_nA, trsf x_trB)\nbegin\n  x_nA=1\n  x_trB.x=1\nend"));
    }

    #[test]
    fn used_copies_and_references_are_not_reported() {
        assert_eq!(check(&RULE, "program p(num x_nA)\nbegin\n  x_nA=x_nA+1\n  ?x_nA\nend"), "");
        assert_eq!(check(&RULE, "program p(num& x_nA, dio x_doB)\nbegin\n  x_nA=1\n  x_doB=true\nend"), "");
    }
}
