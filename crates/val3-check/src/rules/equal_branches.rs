//! V0318: an `if` whose branches are all the same.

use val3_analysis::body::{Body, Stmt, StmtKind};

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// All branches of an `if`, its `else` included, contain the same code.
    ///
    /// ## Why
    /// The condition decides nothing. One of the branches was copied and never changed.
    ///
    /// ## Bad
    /// ```val3
    /// num nPart
    /// num nTray
    ///
    /// if nPart>3
    ///   nTray=1
    /// else
    ///   nTray=1
    /// endIf
    /// putln(nTray)
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nPart
    /// num nTray
    ///
    /// if nPart>3
    ///   nTray=1
    /// else
    ///   nTray=2
    /// endIf
    /// putln(nTray)
    /// ```
    V0318 "equal-branches" Warning, Program: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    for stmt in program.stmts() {
        let StmtKind::If { arms, otherwise: Some(otherwise) } = &stmt.kind else { continue };
        let is_same = arms.iter().all(|(_, block)| is_same_block(program.body, block, otherwise));
        let condition = arms.first().and_then(|(condition, _)| *condition);
        if let Some(condition) = condition.filter(|_| is_same && !otherwise.is_empty()) {
            found.report(&RULE, program.range(condition), word());
        }
    }
}

/// Whether two blocks consist of the same statements, apart from comments and spacing.
fn is_same_block(body: &Body, left: &[Stmt], right: &[Stmt]) -> bool {
    left.len() == right.len() && left.iter().zip(right).all(|(left, right)| is_same_stmt(body, left, right))
}

fn is_same_stmt(body: &Body, left: &Stmt, right: &Stmt) -> bool {
    let (exprs, others) = (left.kind.exprs(), right.kind.exprs());
    std::mem::discriminant(&left.kind) == std::mem::discriminant(&right.kind)
        && left.kind != StmtKind::Error
        && shape(&left.kind) == shape(&right.kind)
        && exprs.len() == others.len()
        && exprs.iter().zip(&others).all(|(left, right)| body.is_same(*left, *right))
        && left.blocks().count() == right.blocks().count()
        && left.blocks().zip(right.blocks()).all(|(left, right)| is_same_block(body, left, right))
}

/// Properties that the lists of expressions and blocks do not show.
fn shape(kind: &StmtKind) -> (bool, Vec<usize>) {
    match kind {
        StmtKind::If { otherwise, .. } => (otherwise.is_some(), Vec::new()),
        StmtKind::For { step, .. } => (step.is_some(), Vec::new()),
        StmtKind::Switch { cases, .. } => (false, cases.iter().map(|(values, _)| values.len()).collect()),
        StmtKind::TaskCreate { synchronous, .. } => (*synchronous, Vec::new()),
        _ => (false, Vec::new()),
    }
}

fn word() -> Wording {
    Wording::new("all branches of this `if` are the same", "decides nothing", "change a branch, or remove the `if`")
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    #[test]
    fn equal_branches_are_reported() {
        expect![[r#"
            start.pgx:5 `nA==1` all branches of this `if` are the same
              | decides nothing
              ? change a branch, or remove the `if`
            start.pgx:13 `nA==3` all branches of this `if` are the same
              | decides nothing
              ? change a branch, or remove the `if`
        "#]]
        .assert_eq(&check(
            &RULE,
            "num nA\nnum nB\nif nA==1\n// one\nnB=1\nelseIf nA==2\nnB = (1)\nelse\nnB=1\nendIf\n\
             if nA==3\nfor nB=1 to 3\nput(nB)\nendFor\nelse\nfor nB=1 to 3\nput(nB)\nendFor\nendIf",
        ));
    }

    #[test]
    fn different_branches_are_not_reported() {
        for code in [
            "if nA==1\nnB=1\nelse\nnB=2\nendIf",
            "if nA==1\nnB=1\nelseIf nA==2\nnB=1\nelse\nnB=2\nendIf",
            "if nA==1\nnB=1\nelseIf nA==2\nnB=1\nendIf",
            "if nA==1\n// nB=1\nelse\n// nB=1\nendIf",
            "if nA==1\nfor nB=1 to 3\nput(nB)\nendFor\nelse\nfor nB=1 to 3 step 2\nput(nB)\nendFor\nendIf",
        ] {
            assert_eq!(check(&RULE, &format!("num nA\nnum nB\n{code}")), "", "{code}");
        }
    }
}
