//! V0234: an array without an index as a single value.

use val3_analysis::body::{ExprId, StmtKind};
use val3_analysis::effects::RootVariable;
use val3_lang::types::Container;
use val3_syntax::TextRange;

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// An array of several values is passed to a parameter that accepts a single value.
    ///
    /// ## Why
    /// A container is never passed by value (2.6). Where a single value is needed, the name of a one-dimensional array
    /// means its value with index 0, and the other values are silently ignored. Write `[0]` if the first one is meant.
    ///
    /// ## Bad
    /// ```val3
    /// num nTimes[10]
    ///
    /// call show(nTimes)
    ///
    /// program show(num x_nTime)
    /// begin
    ///   put(x_nTime)
    /// end
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nTimes[10]
    ///
    /// call show(nTimes[0])
    ///
    /// program show(num x_nTime)
    /// begin
    ///   put(x_nTime)
    /// end
    /// ```
    V0234 "array-without-index" Info, Program: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    let calls = program.stmts().iter().copied().filter_map(|stmt| match stmt.kind {
        StmtKind::Call(call) => program.program_call(call),
        _ => None,
    });
    let tasks = program.task_creations().map(|task| task.call);
    for call in calls.chain(tasks) {
        for (param, argument) in call.arguments() {
            if param.container == Container::Element && !param.loose && is_array(program, argument) {
                let name = program.text(argument);
                let end = TextRange::empty(program.range(program.body.without_parentheses(argument)).end());
                found
                    .report(&RULE, program.range(argument), word(name, &param.name))
                    .related_at(program.parameter(&call, &param.name), "the parameter that receives it")
                    .fix(format!("write `{name}[0]`"), true, [program.write(end, "[0]")]);
            }
        }
    }
}

/// Whether it is a variable that was declared with several values. Parameters are not reported, because many programs
/// pass an element to an array parameter.
fn is_array(program: &ProgramView<'_>, id: ExprId) -> bool {
    let ty = program.inference.ty(id);
    let is_param = matches!(program.effects.root(id), Some(RootVariable::Param(_)));
    matches!(ty.container, Container::Array { .. }) && !ty.is_unknown() && !is_param
}

fn word(name: &str, parameter: &str) -> Wording {
    Wording::new(
        format!("`{name}` is an array, but the parameter `{parameter}` receives only its first value"),
        format!("means `{name}[0]`"),
        "write the index that is meant",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    #[test]
    fn arrays_used_as_values_are_reported() {
        expect![[r#"
            start.pgx:5 `nA` `nA` is an array, but the parameter `x` receives only its first value
              | means `nA[0]`
              ? write the index that is meant
              > p.pgx:5 `x` the parameter that receives it
              ! write `nA[0]`
            start.pgx:6 `nA` `nA` is an array, but the parameter `x` receives only its first value
              | means `nA[0]`
              ? write the index that is meant
              > q.pgx:5 `x` the parameter that receives it
              ! write `nA[0]`
            start.pgx:7 `nA` `nA` is an array, but the parameter `x` receives only its first value
              | means `nA[0]`
              ? write the index that is meant
              > p.pgx:5 `x` the parameter that receives it
              ! write `nA[0]`
        "#]]
        .assert_eq(&check(
            &RULE,
            "num nA[3]\ncall p(nA)\ncall q(nA)\ntaskCreate \"t\",1,p(nA)\n\
             program p(num x)\nbegin\nput(x)\nend\nprogram q(num& x)\nbegin\nx=1\nend",
        ));
    }

    #[test]
    fn whole_arrays_and_single_values_are_not_reported() {
        assert_eq!(
            check(
                &RULE,
                "num nA[3]\nnum n\nn=size(nA)\nn=nA[1]\nput(n)\ncall p(nA)\nresize(nA,1,4)\n\
                 program p(num& x[])\nnum l\nbegin\nl=x[0]\nput(l)\nend"
            ),
            ""
        );
    }
}
