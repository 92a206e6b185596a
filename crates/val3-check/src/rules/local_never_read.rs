//! V0120: a local variable that is written but never read.

use val3_analysis::items::declarations::{Declared, all_locals};

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// A program writes a local variable but never reads it.
    ///
    /// ## Why
    /// The value is lost when the program ends. Often the program reads a wrong variable instead. If a result is not
    /// needed, some instructions can be called without an assignment: `getKey()` instead of `l_nKey=getKey()`.
    ///
    /// ## Bad
    /// ```val3
    /// program start()
    ///   num l_nCount
    /// begin
    ///   l_nCount=1
    /// end
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// program start()
    ///   num l_nCount
    /// begin
    ///   l_nCount=1
    ///   putln(l_nCount)
    /// end
    /// ```
    V0120 "local-never-read" Info, Program: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    let used = &program.variable_use().locals;
    if used.values().all(|uses| uses.may_read()) {
        return;
    }
    for Declared { name, range, .. } in all_locals(program.db, program.file) {
        let is_lost = used.get(&name).is_some_and(|uses| uses.written && !uses.may_read());
        if is_lost && !program.is_linkable(&name) {
            found.report(&RULE, range, word(&name));
        }
    }
}

fn word(name: &str) -> Wording {
    Wording::new(
        format!("the program writes its local variable `{name}` but never reads it"),
        "never read",
        "remove it, or use its value",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    #[test]
    fn locals_that_are_only_written_are_reported() {
        expect![[r#"
            start.pgx:5 `l_nA` the program writes its local variable `l_nA` but never reads it
              | never read
              ? remove it, or use its value
            start.pgx:6 `l_trB` the program writes its local variable `l_trB` but never reads it
              | never read
              ? remove it, or use its value
        "#]]
        .assert_eq(&check(&RULE, "program start()\n  num l_nA\n  trsf l_trB\nbegin\n  l_nA=1\n  l_trB.x=2\nend"));
    }

    #[test]
    fn reads_references_counters_and_outputs_are_not_reported() {
        let listing = "program start()\n  num l_nA\n  num l_i\n  dio l_diC\n  bool l_bD\nbegin\n  l_nA=1\n  ?l_nA\n  \
                       for l_i=0 to 2\n  endFor\n  l_diC=true\n  l_bD=false\n  setMutex(l_bD)\nend";
        assert_eq!(check(&RULE, listing), "");
    }
}
