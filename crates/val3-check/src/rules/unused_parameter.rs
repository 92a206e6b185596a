//! V0114: a parameter that its program does not use.

use val3_analysis::items::declarations::{Declared, all_params};

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// A private program has an unused parameter.
    ///
    /// ## Why
    /// Every caller passes a value without an effect. Either the parameter is left over or the program does not use it
    /// by mistake. Public programs are not reported, because an interface may require their parameters, nor programs
    /// without a line of code.
    ///
    /// ## Bad
    /// ```val3
    /// call show(3,"red")
    ///
    /// program show(num x_nLine, string x_sText)
    /// begin
    ///   putln(x_sText)
    /// end
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// call show(3,"red")
    ///
    /// program show(num x_nLine, string x_sText)
    /// begin
    ///   gotoxy(0,x_nLine)
    ///   put(x_sText)
    /// end
    /// ```
    V0114 "unused-parameter" Info, Program: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    let params = &program.header.params;
    if program.header.public || params.is_empty() || program.body.block.is_empty() {
        return;
    }
    let used = &program.variable_use().params;
    if params.iter().all(|param| used.contains_key(&param.name)) {
        return;
    }
    for Declared { name, range, .. } in all_params(program.db, program.file) {
        if !used.contains_key(&name) {
            found.report(&RULE, range, word(program.name(), &name));
        }
    }
}

fn word(program: &str, name: &str) -> Wording {
    Wording::new(
        format!("`{program}` does not use its parameter `{name}`"),
        "never used",
        "use it, or remove it here and at each call",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    #[test]
    fn a_parameter_that_is_never_named_is_reported() {
        expect![[r#"
            p.pgx:5 `x_nA` `p` does not use its parameter `x_nA`
              | never used
              ? use it, or remove it here and at each call
        "#]]
        .assert_eq(&check(&RULE, "call p(1,2)\nprogram p(num x_nA, num x_nB)\nbegin\n  ?x_nB\nend"));
    }

    #[test]
    fn interfaces_and_empty_programs_are_not_reported() {
        assert_eq!(check(&RULE, "public program p(num x_nA)\nbegin\n  cls()\nend"), "");
        assert_eq!(check(&RULE, "program p(num x_nA)\nbegin\n  // later\nend"), "");
        assert_eq!(check(&RULE, "program p(num& x_nA)\nbegin\n  x_nA=1\nend"), "");
    }
}
