//! V0410: a global frame, tool or point that refers to a local one.

use val3_analysis::body::{Expr, ExprId, StmtKind};
use val3_analysis::effects::RootVariable;
use val3_lang::instructions::{LINK, gives_point_in_frame};
use val3_lang::runtime_errors::GLOBAL_REFERS_TO_LOCAL;
use val3_lang::types::BaseType;

use crate::diagnostic::Wording;
use crate::lint::{Call, Findings, ProgramView};
use crate::phrase::runtime_error;
use crate::rule::rule;

rule! {
    /// A global frame, tool or point gets a local variable as its reference.
    ///
    /// ## Why
    /// The local variable ceases to exist when its program ends, and the global one would have no reference. The line
    /// raises run-time error 165. The rule covers `link`, and points that `here` or `jointToPoint` returns in a local
    /// frame.
    ///
    /// ## Bad
    /// ```val3
    /// frame fPart
    ///
    /// program place()
    ///   frame l_fTable
    /// begin
    ///   link(l_fTable,world)
    ///   link(fPart,l_fTable)
    /// end
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// frame fTable
    /// frame fPart
    ///
    /// program place()
    /// begin
    ///   link(fTable,world)
    ///   link(fPart,fTable)
    /// end
    /// ```
    V0410 "global-refers-to-local" Error, Program: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    for call in program.calls_of(LINK) {
        if let [target, reference] = *call.args {
            report(program, target, reference, found);
        }
    }
    for stmt in program.stmts() {
        if let StmtKind::Assign { target, value } = stmt.kind
            && let Some(frame) =
                program.call_of(program.body.without_parentheses(value)).and_then(|call| frame_of(call))
        {
            report(program, target, frame, found);
        }
    }
}

/// Frame in which the call returns its point.
fn frame_of(call: &Call<'_>) -> Option<ExprId> {
    let mut arguments = call.arguments().filter(|_| gives_point_in_frame(call.instruction.name));
    arguments.find(|(param, _)| param.ty == Some(BaseType::Frame)).map(|(_, argument)| argument)
}

fn report(program: &ProgramView<'_>, target: ExprId, reference: ExprId, found: &mut Findings) {
    let is_global = matches!(program.effects.root(target), Some(RootVariable::Data(_) | RootVariable::Item(..)));
    if is_global && is_local(program, reference) {
        found
            .report(&RULE, program.range(reference), word(program.text(target), program.text(reference)))
            .related_at(program.declaration(reference), "declared here");
    }
}

/// Whether the expression is a local variable, possibly in parentheses.
fn is_local(program: &ProgramView<'_>, id: ExprId) -> bool {
    let is_variable = matches!(program.body.expr(id), Expr::Name(_) | Expr::Index(..) | Expr::Field { .. });
    is_variable && matches!(program.effects.root(id), Some(RootVariable::Local(_)))
}

fn word(target: &str, reference: &str) -> Wording {
    Wording::new(
        format!("the global `{target}` cannot be given in the local variable `{reference}`"),
        runtime_error(GLOBAL_REFERS_TO_LOCAL),
        format!("declare `{reference}` as global data"),
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    fn program(code: &str) -> String {
        format!(
            "frame fA[2]\ntool tA\npoint pA\njoint jA\n\nprogram p(frame x_f, frame& x_fRef)\n  frame l_f[2]\n  tool l_t\n  \
             point l_p\nbegin\n{code}\nend"
        )
    }

    #[test]
    fn a_global_linked_to_a_local_is_reported() {
        expect![[r#"
            p.pgx:14 `l_f` the global `fA[1]` cannot be given in the local variable `l_f`
              | run-time error 165: global refers to local
              ? declare `l_f` as global data
              > p.pgx:9 `l_f` declared here
        "#]]
        .assert_eq(&check(&RULE, &program("link(fA[1],l_f)")));
        for line in ["link(tA,l_t)", "link(pA,l_f[1])", "pA=here(tA,l_f)", "pA=(jointToPoint(tA,l_f[1],jA))"] {
            assert_eq!(check(&RULE, &program(line)).matches("error 165").count(), 1, "{line}");
        }
    }

    #[test]
    fn other_links_are_not_reported() {
        for line in ["link(fA[1],fA[0])", "link(l_f,fA)", "link(l_p,l_f)", "l_p=here(tA,l_f)", "link(fA,x_fRef)"] {
            assert_eq!(check(&RULE, &program(line)), "", "{line}");
        }
        assert_eq!(check(&RULE, &program("link(x_fRef,l_f)\npA=compose(pA,l_f,{0,0,0,0,0,0})")), "");
    }
}
