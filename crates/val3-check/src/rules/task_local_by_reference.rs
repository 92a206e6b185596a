//! V0320: a local variable by reference for the program of a task.

use val3_analysis::effects::RootVariable;

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// The program of a task gets a local variable by reference.
    ///
    /// ## Why
    /// The variable ceases to exist when the program that creates the task ends, but the task continues and would still
    /// read and write it. `taskCreate` and `taskCreateSync` accept no local variable by reference, and no parameter
    /// that was passed by value, because that is a local variable (5.10).
    ///
    /// ## Bad
    /// ```val3
    /// program begins()
    ///   num l_nCount
    /// begin
    ///   taskCreate "count",10,count(l_nCount)
    /// end
    ///
    /// program count(num& x_nCount)
    /// begin
    ///   x_nCount=x_nCount+1
    /// end
    ///
    /// call begins()
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nCount
    ///
    /// taskCreate "count",10,count(nCount)
    ///
    /// program count(num& x_nCount)
    /// begin
    ///   x_nCount=x_nCount+1
    /// end
    /// ```
    V0320 "task-local-by-reference" Error, Program: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    for task in program.task_creations() {
        for (param, argument) in task.call.arguments() {
            if !param.by_reference || param.loose {
                continue;
            }
            if let Some(what) = ends_with_program(program, program.effects.root(argument)) {
                let text = program.text(argument);
                found
                    .report(&RULE, program.range(argument), word(what, text, &param.name))
                    .related_at(program.declaration(argument), "declared here")
                    .related_at(program.parameter(&task.call, &param.name), "the parameter that receives it");
            }
        }
    }
}

/// Describes a variable that ceases to exist when its program ends; `None` for other variables.
pub(crate) fn ends_with_program(program: &ProgramView<'_>, root: Option<RootVariable>) -> Option<&'static str> {
    match root? {
        RootVariable::Local(_) => Some("the local variable"),
        RootVariable::Param(name) => {
            let param = program.header.params.iter().find(|param| param.name == name)?;
            (!param.by_reference && !param.loose).then_some("the value parameter")
        }
        RootVariable::Data(_) | RootVariable::Item(..) => None,
    }
}

fn word(what: &str, variable: &str, parameter: &str) -> Wording {
    Wording::new(
        format!("a task cannot get {what} `{variable}` by reference"),
        "ends with this program, before the task does",
        format!("use a global variable, or take `{parameter}` by value"),
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    const COUNT: &str = "program count(num& x_n)\nbegin\nx_n=1\nend\nprogram show(num x_n)\nbegin\nput(x_n)\nend\n";

    #[test]
    fn local_variables_by_reference_are_reported() {
        let code = "bool b\nprogram p(num x_n)\nnum l_n[2]\nbegin\ntaskCreate \"a\",10,count(l_n[1])\n\
                    taskCreateSync \"b\",0.02,b,count(x_n)\nend\n";
        expect![[r#"
            p.pgx:11 `l_n[1]` a task cannot get the local variable `l_n[1]` by reference
              | ends with this program, before the task does
              ? use a global variable, or take `x_n` by value
              > p.pgx:8 `l_n` declared here
              > count.pgx:5 `x_n` the parameter that receives it
            p.pgx:12 `x_n` a task cannot get the value parameter `x_n` by reference
              | ends with this program, before the task does
              ? use a global variable, or take `x_n` by value
              > p.pgx:5 `x_n` declared here
              > count.pgx:5 `x_n` the parameter that receives it
        "#]]
        .assert_eq(&check(&RULE, &format!("{COUNT}{code}")));
    }

    #[test]
    fn globals_and_values_are_not_reported() {
        let code = "num n\nprogram p(num& x_n)\nnum l_n\nbegin\nl_n=1\ntaskCreate \"a\",10,count(n)\n\
                    taskCreate \"b\",10,count(x_n)\ntaskCreate \"c\",10,show(l_n)\ncall count(l_n)\nend\n";
        assert_eq!(check(&RULE, &format!("{COUNT}{code}")), "");
    }
}
