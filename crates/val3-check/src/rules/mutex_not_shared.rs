//! V0327: a mutex in a local variable.

use val3_lang::instructions::SET_MUTEX;

use super::task_local_by_reference::ends_with_program;
use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// `setMutex` locks a local variable.
    ///
    /// ## Why
    /// A mutex protects data shared by tasks: each task waits for the same variable (5.9). A local variable belongs to
    /// one call of one program. It is `false` at first, so `setMutex` never waits and protects nothing. A second
    /// `setMutex` of it never returns.
    ///
    /// ## Bad
    /// ```val3
    /// program show(string x_sText)
    ///   bool l_bScreen
    /// begin
    ///   setMutex(l_bScreen)
    ///   putln(x_sText)
    ///   l_bScreen=false
    /// end
    ///
    /// call show("ready")
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// bool bScreen
    ///
    /// program show(string x_sText)
    /// begin
    ///   setMutex(bScreen)
    ///   putln(x_sText)
    ///   bScreen=false
    /// end
    ///
    /// call show("ready")
    /// ```
    V0327 "mutex-not-shared" Warning, Program: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    for call in program.calls_of(SET_MUTEX) {
        let Some(mutex) = call.args.first() else { continue };
        if let Some(what) = ends_with_program(program, program.effects.root(*mutex)) {
            found.report(&RULE, program.range(*mutex), word(what, program.text(*mutex)));
        }
    }
}

fn word(what: &str, variable: &str) -> Wording {
    Wording::new(
        format!("{what} `{variable}` protects nothing: no other task can access it"),
        "belongs to this call of the program",
        "use a global variable",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    #[test]
    fn local_variables_are_reported() {
        expect![[r#"
            p.pgx:11 `l_b` the local variable `l_b` protects nothing: no other task can access it
              | belongs to this call of the program
              ? use a global variable
            p.pgx:12 `x_b` the value parameter `x_b` protects nothing: no other task can access it
              | belongs to this call of the program
              ? use a global variable
        "#]]
        .assert_eq(&check(&RULE, "program p(bool x_b)\nbool l_b\nbegin\nsetMutex(l_b)\nsetMutex(x_b)\nend"));
    }

    #[test]
    fn shared_variables_are_not_reported() {
        assert_eq!(check(&RULE, "bool b\nprogram p(bool& x_b)\nbegin\nsetMutex(b)\nsetMutex(x_b)\nend"), "");
    }
}
