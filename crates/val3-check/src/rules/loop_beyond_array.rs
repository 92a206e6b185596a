//! V0333: a loop that uses an index beyond the array's end.

use val3_analysis::body::{Expr, ExprId, Stmt, StmtKind};
use val3_analysis::effects::{AccessKind, RootVariable};
use val3_lang::instructions::{SIZE, TASK_KILL};
use val3_lang::operators::BinaryOp;
use val3_lang::runtime_errors::INDEX_TOO_LARGE;
use val3_lang::types::Container;

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView};
use crate::phrase::runtime_error;
use crate::rule::rule;

rule! {
    /// The counter of a loop reaches the size of an array that the loop uses with this index.
    ///
    /// ## Why
    /// Indexes begin with 0, so the last one is `size(…)-1` (2.5.4). The limit of a `for` belongs to its values. In the
    /// last pass the index is beyond the array, which is run-time error 20.
    ///
    /// ## Bad
    /// ```val3
    /// num nParts[4]
    /// num nI
    ///
    /// for nI=0 to size(nParts)
    ///   putln(nParts[nI])
    /// endFor
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nParts[4]
    /// num nI
    ///
    /// for nI=0 to size(nParts)-1
    ///   putln(nParts[nI])
    /// endFor
    /// ```
    V0333 "loop-beyond-array" Error, Program: check
}

/// A loop that counts up by 1, including its limit.
struct CountingLoop<'p> {
    counter: ExprId,
    limit: ExprId,
    block: &'p [Stmt],
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    for stmt in program.stmts() {
        let Some(counting) = for_loop(program, stmt).or_else(|| while_loop(program, stmt)) else { continue };
        let Some((element, array)) = element_beyond(program, &counting) else { continue };
        if may_leave(program, stmt) || changes(program, stmt, array) {
            continue;
        }
        let limit = program.range(counting.limit);
        let reported =
            found.report(&RULE, program.range(element), word(program.text(array), program.text(counting.limit)));
        let title = "end one earlier";
        let last = format!("{}-1", program.text(counting.limit));
        let edit = size_of(program, counting.limit).map(|_| program.write(limit, &last));
        reported.related(limit, "the last index").fix(title, false, edit);
    }
}

fn for_loop<'p>(program: &ProgramView<'_>, stmt: &'p Stmt) -> Option<CountingLoop<'p>> {
    let StmtKind::For { counter, start, stop, step, block } = &stmt.kind else { return None };
    let (counter, start, limit) = ((*counter)?, (*start)?, (*stop)?);
    let is_by_one = step.is_none_or(|step| program.body.number(step) == Some(1.0));
    let start = program.body.number(start).filter(|start| start.fract() == 0.0 && *start >= 0.0)?;
    let is_run = program.body.number(limit).is_none_or(|limit| limit >= start && limit.fract() == 0.0);
    // The block is not executed for an empty array; a start beyond 0 may exceed the array size.
    let is_run = is_run && (start == 0.0 || program.body.number(limit).is_some());
    let writes = writes(program, stmt, counter);
    (is_by_one && is_run && writes == 0).then_some(CountingLoop { counter, limit, block })
}

fn while_loop<'p>(program: &ProgramView<'_>, stmt: &'p Stmt) -> Option<CountingLoop<'p>> {
    let StmtKind::While { condition, block } = &stmt.kind else { return None };
    let (counter, limit) = match program.body.expr(program.body.without_parentheses((*condition)?)) {
        Expr::Binary(BinaryOp::LessOrEqual, counter, limit) => (*counter, *limit),
        Expr::Binary(BinaryOp::GreaterOrEqual, limit, counter) => (*counter, *limit),
        _ => return None,
    };
    let counts = block.iter().any(|stmt| is_increment(program, stmt, counter));
    let is_certain = counts && writes(program, stmt, counter) == 1;
    is_certain.then_some(CountingLoop { counter, limit, block })
}

/// Whether the statement is `n=n+1`.
fn is_increment(program: &ProgramView<'_>, stmt: &Stmt, counter: ExprId) -> bool {
    let StmtKind::Assign { target, value } = stmt.kind else { return false };
    let Expr::Binary(BinaryOp::Add, left, right) = program.body.expr(program.body.without_parentheses(value)) else {
        return false;
    };
    program.is_same(target, counter) && program.is_same(*left, counter) && program.body.number(*right) == Some(1.0)
}

/// Number of accesses in a loop that may write the counter, without the write of `for` itself.
fn writes(program: &ProgramView<'_>, stmt: &Stmt, counter: ExprId) -> usize {
    let root = program.effects.root(counter);
    let inside = program.effects.all().iter().filter(|access| {
        access.kind != AccessKind::Read && access.id != counter && stmt.range.contains_range(program.range(access.id))
    });
    inside.filter(|access| Some(&access.root) == root.as_ref()).count()
}

/// First element that each pass uses with the counter as index, in an array that is not larger than the limit.
fn element_beyond(program: &ProgramView<'_>, counting: &CountingLoop<'_>) -> Option<(ExprId, ExprId)> {
    if !matches!(program.body.expr(counting.counter), Expr::Name(_)) {
        return None;
    }
    for stmt in counting.block {
        let exprs = match &stmt.kind {
            StmtKind::Assign { target, value } => vec![*value, *target],
            StmtKind::Call(id) | StmtKind::Print(id) | StmtKind::Expr(id) => vec![*id],
            _ => Vec::new(),
        };
        for part in exprs.into_iter().filter(|id| !branches(program, *id)).flat_map(|id| program.body.within(id)) {
            let Expr::Index(array, keys) = program.body.expr(part) else { continue };
            let is_counter = matches!(**keys, [key] if program.is_same(key, counting.counter));
            if is_counter && is_array(program, *array) && reaches_size(program, counting.limit, *array) {
                return Some((part, *array));
            }
        }
        if is_increment(program, stmt, counting.counter) {
            return None;
        }
    }
    None
}

/// Whether a part of the expression may not be evaluated.
fn branches(program: &ProgramView<'_>, id: ExprId) -> bool {
    // The element may be an argument that only marks where a part of the array starts.
    let mut parts = program.body.within(id).map(|part| program.body.expr(part));
    parts.any(|part| matches!(part, Expr::Binary(BinaryOp::And | BinaryOp::Or, ..)))
}

fn is_array(program: &ProgramView<'_>, array: ExprId) -> bool {
    matches!(program.body.expr(array), Expr::Name(_) | Expr::Path { .. })
        && program.inference.ty(array).container == Container::Array { dims: 1 }
}

/// Whether the limit is the size of the array, or a constant that is not below it.
fn reaches_size(program: &ProgramView<'_>, limit: ExprId, array: ExprId) -> bool {
    if let Some(limit) = program.body.number(limit) {
        return program.certain_size(array).is_some_and(|size| limit.round() >= f64::from(size));
    }
    size_of(program, limit).is_some_and(|measured| program.is_same(measured, array))
}

/// The array in `size(array)`.
fn size_of(program: &ProgramView<'_>, limit: ExprId) -> Option<ExprId> {
    let call = program.call_of(program.body.without_parentheses(limit)).filter(|call| call.instruction.name == SIZE)?;
    match *call.args {
        [array] => Some(array),
        _ => None,
    }
}

/// Whether the loop may end before its last pass.
fn may_leave(program: &ProgramView<'_>, stmt: &Stmt) -> bool {
    let kills = || program.calls_of(TASK_KILL).any(|call| stmt.range.contains_range(program.range(call.id)));
    stmt.holds(&StmtKind::Return) || kills()
}

/// Whether a line of the loop may change the size of the array.
fn changes(program: &ProgramView<'_>, stmt: &Stmt, array: ExprId) -> bool {
    let root: Option<RootVariable> = program.effects.root(array);
    program.effects.all().iter().any(|access| {
        access.kind == AccessKind::Reference
            && Some(&access.root) == root.as_ref()
            && stmt.range.contains_range(program.range(access.id))
    })
}

fn word(array: &str, limit: &str) -> Wording {
    Wording::new(
        format!("in the last pass the index is `{limit}`, which is beyond the end of `{array}`"),
        runtime_error(INDEX_TOO_LARGE),
        format!("the last index is `size({array})-1`"),
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    fn program(code: &str) -> String {
        check(&RULE, &format!("num nA[5]\nnum nB[3]\npublic num nC[5]\nnum nI\nnum nX\n{code}"))
    }

    #[test]
    fn loops_beyond_the_end_are_reported() {
        expect![[r#"
            start.pgx:6 `nA[nI]` in the last pass the index is `size(nA)`, which is beyond the end of `nA`
              | run-time error 20: index too large
              ? the last index is `size(nA)-1`
              > start.pgx:5 `size(nA)` the last index
              ! end one earlier (unsafe)
            start.pgx:10 `nC[nI]` in the last pass the index is `size(nC)`, which is beyond the end of `nC`
              | run-time error 20: index too large
              ? the last index is `size(nC)-1`
              > start.pgx:9 `size(nC)` the last index
              ! end one earlier (unsafe)
            start.pgx:14 `nA[nI]` in the last pass the index is `5`, which is beyond the end of `nA`
              | run-time error 20: index too large
              ? the last index is `size(nA)-1`
              > start.pgx:13 `5` the last index
        "#]]
        .assert_eq(&program(
            "for nI=0 to size(nA)\nputln(nA[nI])\nendFor\nnI=0\nwhile nI<=size(nC)\nnC[nI]=1\nnI=nI+1\nendWhile\n\
             for nI=1 to 5\nnX=nA[nI]+nB[0]\nendFor",
        ));
    }

    #[test]
    fn other_loops_are_not_reported() {
        for code in [
            "for nI=0 to size(nA)-1\nputln(nA[nI])\nendFor",
            "for nI=0 to 4\nputln(nA[nI])\nendFor",
            "for nI=1 to size(nA)\nputln(nA[nI-1])\nendFor",
            "for nI=0 to size(nA)\nif nI<size(nA)\nputln(nA[nI])\nendIf\nendFor",
            "for nI=0 to size(nB)\nputln(nA[nI])\nendFor",
            "for nI=0 to 5\nputln(nC[nI])\nendFor",
            "for nI=0 to size(nA)\nif nX==1\nreturn\nendIf\nputln(nA[nI])\nendFor",
            "for nI=0 to size(nA)\nappend(nA)\nputln(nA[nI])\nendFor",
            "while nI<=size(nA)\nnI=nI+1\nputln(nA[nI-1])\nendWhile",
            "while nI<=size(nA)\nputln(nA[nI])\nnI=nI+2\nendWhile",
            "for nI=0 to size(nA) step 2\nputln(nA[nI])\nendFor",
        ] {
            assert_eq!(program(code), "", "{code}");
        }
    }
}
