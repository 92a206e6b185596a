//! V0115: a local variable that its program does not use.

use val3_analysis::items::declarations::{Declared, all_locals};

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView, removal};
use crate::rule::rule;

rule! {
    /// A program declares a local variable and does not use it.
    ///
    /// ## Why
    /// The variable is left over, or the program uses the wrong variable. It also needs memory and time at each call,
    /// because locals are created whenever the program starts.
    ///
    /// ## Bad
    /// ```val3
    /// program start()
    ///   num l_nCount
    /// begin
    ///   putln("ready")
    /// end
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// program start()
    ///   num l_nCount
    /// begin
    ///   l_nCount=len("ready")
    ///   putln(l_nCount)
    /// end
    /// ```
    V0115 "unused-local" Info, Program: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    let used = &program.variable_use().locals;
    if program.header.locals.iter().all(|local| used.contains_key(&local.name)) {
        return;
    }
    for Declared { name, range, element } in all_locals(program.db, program.file) {
        if !used.contains_key(&name) {
            found.report(&RULE, range, word(&name)).fix(
                format!("remove `{name}`"),
                true,
                [removal::of_element(program.db, program.file, element)],
            );
        }
    }
}

fn word(name: &str) -> Wording {
    Wording::new(format!("the program does not use its local variable `{name}`"), "never used", "remove it")
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    #[test]
    fn a_local_that_is_never_named_is_reported() {
        expect![[r#"
            start.pgx:6 `l_pB` the program does not use its local variable `l_pB`
              | never used
              ? remove it
              ! remove `l_pB`
        "#]]
        .assert_eq(&check(&RULE, "program start()\n  num l_nA\n  point l_pB\nbegin\n  l_nA=1\nend"));
    }

    #[test]
    fn any_use_counts_as_a_use() {
        let listing = "program start()\n  num l_nA\n  num l_nB[2]\n  sio l_siC\nbegin\n  l_nA=size(l_nB)\n  sioLink(l_siC,l_siC)\nend";
        assert_eq!(check(&RULE, listing), "");
    }
}
