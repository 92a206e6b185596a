//! V0312: a value that is stored and never used.

use std::collections::VecDeque;
use val3_analysis::db::FileRange;

use val3_analysis::body::{Expr, ExprId};
use val3_analysis::effects::{AccessKind, RootVariable};
use val3_analysis::flow::{FlowNodeId, PointKind};
use val3_lang::types::BaseType;
use val3_syntax::TextRange;

use crate::diagnostic::Wording;
use crate::lint::{Findings, Locals, ProgramView};
use crate::rule::rule;

rule! {
    /// A value is computed and stored in a local variable, and is overwritten or forgotten before anything uses it.
    ///
    /// ## Why
    /// The value was meant to be used: another variable was meant, a line is missing, or the lines are in the wrong
    /// order. A constant initial value is not reported, nor the result of an instruction that has other effects.
    ///
    /// ## Bad
    /// ```val3
    /// num nCount
    ///
    /// program total()
    ///   num l_nSum
    /// begin
    ///   l_nSum=nCount*2
    ///   l_nSum=nCount+1
    ///   putln(l_nSum)
    /// end
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nCount
    ///
    /// program total()
    ///   num l_nSum
    /// begin
    ///   l_nSum=nCount*2
    ///   l_nSum=l_nSum+1
    ///   putln(l_nSum)
    /// end
    /// ```
    V0312 "dead-store" Info, Program: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    let local_use = program.local_use();
    let used = used(program);
    let needed = local_use.needed(program.flow());
    for (id, point) in program.flow().points() {
        let PointKind::Assign { value, .. } = point.kind else { continue };
        let Some((bit, access)) = local_use.at(id).last().filter(|(_, access)| access.kind == AccessKind::Write) else {
            continue;
        };
        let is_needed = needed.after(id).is_none_or(|needed| needed & bit != 0);
        let RootVariable::Local(name) = &access.root else { continue };
        // An assignment to an output sets it.
        if program.inference.ty(access.id).base.builtin().is_some_and(BaseType::is_linkable) {
            continue;
        }
        if !is_needed && used & bit != 0 && is_computed(program, value) {
            let again = overwritten(program, id, *bit).map(|range| FileRange { file: program.file, range });
            found.report(&RULE, point.range, word(name)).related_at(again, "overwritten here");
        }
    }
}

/// Next line after `from` that overwrites the entire variable, on the first path that reaches one.
fn overwritten(program: &ProgramView<'_>, from: FlowNodeId, variable: Locals) -> Option<TextRange> {
    let flow = program.flow();
    let mut seen = vec![false; flow.len()];
    let mut open: VecDeque<FlowNodeId> = flow.point(from)?.next.iter().copied().collect();
    while let Some(id) = open.pop_front() {
        let (Some(point), Some(seen)) = (flow.point(id), seen.get_mut(id.index())) else { continue };
        let mut accesses = program.local_use().at(id).iter().filter(|(bit, _)| *bit == variable);
        if accesses.any(|(_, access)| access.kind == AccessKind::Write) {
            return Some(point.range).filter(|_| id != from);
        }
        if !std::mem::replace(seen, true) {
            open.extend(&point.next);
        }
    }
    None
}

/// Whether the value is computed without side effects. Initial values of literals and results of instructions with
/// other effects are not reported.
fn is_computed(program: &ProgramView<'_>, value: ExprId) -> bool {
    let mut parts = program.body.within(value).map(|id| program.body.expr(id));
    parts.any(|part| matches!(part, Expr::Name(_) | Expr::Path { .. } | Expr::Call(..))) && program.is_pure(value)
}

/// Variables that are used somewhere. Other variables are reported as unused.
fn used(program: &ProgramView<'_>) -> Locals {
    let uses = program.flow().points().flat_map(|(id, _)| program.local_use().at(id));
    let reads = uses.filter(|(_, access)| matches!(access.kind, AccessKind::Read | AccessKind::Reference));
    reads.fold(0, |all, (bit, _)| all | bit)
}

fn word(name: &str) -> Wording {
    Wording::new(
        format!("the value stored in `{name}` is never used"),
        "overwritten or forgotten before it is used",
        "use the value, or remove the line",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    fn program(code: &str) -> String {
        format!(
            "num nA\nbool bA\ndio dA\n\nprogram start()\n  num l_n\n  num l_nAll[3]\n  dio l_d\nbegin\n{code}\nend\n\nprogram set(num& x_n)\nbegin\n  x_n=1\nend"
        )
    }

    #[test]
    fn values_that_are_never_used_are_reported() {
        expect![[r#"
            start.pgx:10 `l_n=nA` the value stored in `l_n` is never used
              | overwritten or forgotten before it is used
              ? use the value, or remove the line
              > start.pgx:12 `l_n=nA+1` overwritten here
            start.pgx:17 `l_n=nA` the value stored in `l_n` is never used
              | overwritten or forgotten before it is used
              ? use the value, or remove the line
        "#]]
        .assert_eq(&check(&RULE, &program("l_n=nA\nif bA\nl_n=nA+1\nelse\nl_n=nA+2\nendIf\nput(l_n)\nl_n=nA")));
    }

    #[test]
    fn values_used_on_one_path_are_not_reported() {
        let lines = [
            "l_n=nA\nif bA\nl_n=3\nendIf\nput(l_n)",
            "l_n=nA\ncall set(l_n)\nput(l_n)",
            "while bA\nput(l_n)\nl_n=nA\nendWhile",
            "l_nAll[0]=nA\nl_nAll[0]=nA+1\nput(l_nAll[0])",
            "l_n=nA\nl_nAll[l_n]=1",
            "l_n=nA",
            "for l_n=0 to 9\nif bA\nl_n=nA\nendIf\nendFor\nput(l_n)",
            "l_n=nA\nwhile true\ndelay(1)\nendWhile\nput(l_n)",
        ];
        for line in lines {
            assert_eq!(check(&RULE, &program(line)), "", "{line}");
        }
    }

    #[test]
    fn outputs_are_not_reported() {
        assert_eq!(check(&RULE, &program("dioLink(l_d,dA)\nl_d=bA\nl_d=!bA\nbA=l_d\nl_d=bA")), "");
    }

    #[test]
    fn initial_values_and_ignored_results_are_not_reported() {
        assert_eq!(check(&RULE, &program("l_n=0\nl_n=nA\nput(l_n)\nl_n=get()\nl_n=nA\nput(l_n)")), "");
    }
}
