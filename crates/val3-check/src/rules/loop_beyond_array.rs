//! V0333: a loop that uses an index outside the array.

mod counting;

use val3_analysis::body::{Expr, ExprId, Stmt, StmtKind};
use val3_analysis::effects::{AccessKind, RootVariable};
use val3_lang::instructions::TASK_KILL;
use val3_lang::operators::BinaryOp;
use val3_lang::runtime_errors::{INDEX_NEGATIVE, INDEX_TOO_LARGE};
use val3_lang::types::Container;

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView};
use crate::phrase::runtime_error;
use crate::rule::rule;
use counting::{Bound, CountingLoop, is_increment, size_of};

rule! {
    /// The counter of a loop exceeds the indexes of an array that each pass of the loop uses, in the first or last pass.
    ///
    /// ## Why
    /// Indexes begin with 0, so the last one is `size(…)-1` (2.5.4). The limit of a `for` belongs to its values. In the
    /// last pass the index is beyond the array, which is run-time error 20. A loop that counts down from `size(…)` starts
    /// beyond the array, and `nParts[nI+1]` is beyond it in the last pass of a loop to `size(nParts)-1`. An index below 0
    /// is run-time error 21.
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
    V0333 "loop-beyond-array" Error, Member: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    for stmt in program.stmts() {
        let Some(counting) = CountingLoop::new(program, stmt) else { continue };
        let Some(outside) = outside(program, &counting) else { continue };
        if may_leave(program, stmt) || changes(program, stmt, outside.array) {
            continue;
        }
        let wording = outside.word(program, &counting);
        let reported = found.report(&RULE, program.range(outside.element), wording);
        let (at, label) = outside.related(&counting);
        let reported = reported.related(program.range(at), label);
        if let Some(limit) = outside.limit_to_lower(program, &counting) {
            let edit = program.write(program.range(limit), &format!("{}-1", program.text(limit)));
            reported.fix("end one earlier", false, [edit]);
        }
    }
}

/// Element of an array whose index is outside the array in the first or last pass of a loop.
struct Outside {
    element: ExprId,
    array: ExprId,
    /// Difference between the index and the counter.
    offset: f64,
    side: Side,
}

#[derive(PartialEq)]
enum Side {
    BeyondEnd,
    BelowZero,
}

impl Outside {
    fn word(&self, program: &ProgramView<'_>, counting: &CountingLoop<'_>) -> Wording {
        let array = program.text(self.array);
        let pass = if self.is_in_first_pass(counting) { "the first pass" } else { "the last pass" };
        match self.side {
            Side::BeyondEnd => {
                let index = counting.highest.shifted(self.offset).text(program);
                Wording::new(
                    format!("in {pass} the index is `{index}`, which is beyond the end of `{array}`"),
                    runtime_error(INDEX_TOO_LARGE),
                    format!("the last index is `size({array})-1`"),
                )
            }
            Side::BelowZero => {
                let index = counting.lowest.unwrap_or_default() + self.offset;
                Wording::new(
                    format!("in {pass} the index of `{array}` is {index}"),
                    runtime_error(INDEX_NEGATIVE),
                    "the first index is 0",
                )
            }
        }
    }

    fn is_in_first_pass(&self, counting: &CountingLoop<'_>) -> bool {
        counting.is_descending == (self.side == Side::BeyondEnd)
    }

    /// Expression that sets the index, and its label.
    fn related(&self, counting: &CountingLoop<'_>) -> (ExprId, &'static str) {
        match (self.is_in_first_pass(counting), self.offset == 0.0) {
            (true, true) => (counting.start.unwrap_or(counting.stop), "the first index"),
            (true, false) => (counting.start.unwrap_or(counting.stop), "the start of the counter"),
            (false, true) => (counting.stop, "the last index"),
            (false, false) => (counting.stop, "the limit of the counter"),
        }
    }

    /// `size(nParts)` as the limit of a loop that needs `size(nParts)-1`.
    fn limit_to_lower(&self, program: &ProgramView<'_>, counting: &CountingLoop<'_>) -> Option<ExprId> {
        let is_last = self.side == Side::BeyondEnd && !counting.is_descending && self.offset == 0.0;
        (is_last && size_of(program, counting.stop).is_some()).then_some(counting.stop)
    }
}

/// First element that each pass uses with an index that depends on the counter and is outside the array in one pass.
fn outside(program: &ProgramView<'_>, counting: &CountingLoop<'_>) -> Option<Outside> {
    for stmt in counting.block {
        let exprs = match &stmt.kind {
            StmtKind::Assign { target, value } => vec![*value, *target],
            StmtKind::Call(id) | StmtKind::Print(id) | StmtKind::Expr(id) => vec![*id],
            _ => Vec::new(),
        };
        let exprs = exprs.into_iter().filter(|id| !branches(program, *id));
        let mut elements = exprs.flat_map(|id| program.body.within(id));
        let outside = elements.find_map(|element| outside_element(program, counting, element));
        if outside.is_some() || is_increment(program, stmt, counting.counter) {
            return outside;
        }
    }
    None
}

fn outside_element(program: &ProgramView<'_>, counting: &CountingLoop<'_>, element: ExprId) -> Option<Outside> {
    let Expr::Index(array, keys) = program.body.expr(element) else { return None };
    let [key] = **keys else { return None };
    let offset = counting.offset(program, key)?;
    if !is_array(program, *array) {
        return None;
    }
    let is_below = counting.lowest.is_some_and(|lowest| lowest + offset < 0.0);
    let is_beyond = || reaches_size(program, counting.highest.shifted(offset), *array);
    let side = if is_below { Some(Side::BelowZero) } else { is_beyond().then_some(Side::BeyondEnd) };
    Some(Outside { element, array: *array, offset, side: side? })
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

/// Whether an index is not below the size of the array.
fn reaches_size(program: &ProgramView<'_>, index: Bound, array: ExprId) -> bool {
    match index.size_of {
        Some(measured) => index.offset >= 0.0 && program.is_same(measured, array),
        None => program.certain_size(array).is_some_and(|size| index.offset >= f64::from(size)),
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
    fn the_first_pass_of_a_loop_down_is_reported() {
        expect![[r#"
            start.pgx:6 `nC[nI]` in the first pass the index is `size(nC)`, which is beyond the end of `nC`
              | run-time error 20: index too large
              ? the last index is `size(nC)-1`
              > start.pgx:5 `size(nC)` the first index
            start.pgx:9 `nA[nI]` in the first pass the index is `5`, which is beyond the end of `nA`
              | run-time error 20: index too large
              ? the last index is `size(nA)-1`
              > start.pgx:8 `5` the first index
        "#]]
        .assert_eq(&program(
            "for nI=size(nC) to 0 step -1\nnX=nC[nI]\nendFor\nfor nI=5 to 1 step -1\nnX=nA[nI]\nendFor",
        ));
    }

    #[test]
    fn indexes_beside_the_counter_are_reported() {
        expect![[r#"
            start.pgx:6 `nC[nI+1]` in the last pass the index is `size(nC)`, which is beyond the end of `nC`
              | run-time error 20: index too large
              ? the last index is `size(nC)-1`
              > start.pgx:5 `size(nC)-1` the limit of the counter
            start.pgx:9 `nA[1+nI]` in the last pass the index is `5`, which is beyond the end of `nA`
              | run-time error 20: index too large
              ? the last index is `size(nA)-1`
              > start.pgx:8 `4` the limit of the counter
            start.pgx:12 `nC[nI+1]` in the last pass the index is `size(nC)`, which is beyond the end of `nC`
              | run-time error 20: index too large
              ? the last index is `size(nC)-1`
              > start.pgx:11 `size(nC)` the limit of the counter
        "#]]
        .assert_eq(&program(
            "for nI=0 to size(nC)-1\nnX=nC[nI+1]\nendFor\nfor nI=0 to 4\nnX=nA[1+nI]\nendFor\n\
             while nI<size(nC)\nnX=nC[nI+1]\nnI=nI+1\nendWhile",
        ));
    }

    #[test]
    fn indexes_below_zero_are_reported() {
        expect![[r#"
            start.pgx:6 `nC[nI-1]` in the first pass the index of `nC` is -1
              | run-time error 21: index negative
              ? the first index is 0
              > start.pgx:5 `0` the start of the counter
            start.pgx:9 `nA[nI]` in the last pass the index of `nA` is -1
              | run-time error 21: index negative
              ? the first index is 0
              > start.pgx:8 `-1` the last index
        "#]]
        .assert_eq(&program("for nI=0 to size(nC)-1\nnX=nC[nI-1]\nendFor\nfor nI=4 to -1 step -1\nnX=nA[nI]\nendFor"));
    }

    #[test]
    fn a_count_from_one_to_the_size_is_reported() {
        expect![[r#"
            start.pgx:6 `nC[nI]` in the last pass the index is `size(nC)`, which is beyond the end of `nC`
              | run-time error 20: index too large
              ? the last index is `size(nC)-1`
              > start.pgx:5 `size(nC)` the last index
              ! end one earlier (unsafe)
        "#]]
        .assert_eq(&program("for nI=1 to size(nC)\nnX=nC[nI]\nendFor"));
    }

    #[test]
    fn loops_with_the_condition_at_the_end_are_reported() {
        expect![[r#"
            start.pgx:7 `nA[nI]` in the last pass the index is `5`, which is beyond the end of `nA`
              | run-time error 20: index too large
              ? the last index is `size(nA)-1`
              > start.pgx:9 `5` the last index
            start.pgx:12 `nC[nI]` in the last pass the index is `size(nC)`, which is beyond the end of `nC`
              | run-time error 20: index too large
              ? the last index is `size(nC)-1`
              > start.pgx:14 `size(nC)` the last index
              ! end one earlier (unsafe)
            start.pgx:17 `nC[nI+1]` in the last pass the index is `size(nC)`, which is beyond the end of `nC`
              | run-time error 20: index too large
              ? the last index is `size(nC)-1`
              > start.pgx:19 `size(nC)` the limit of the counter
            start.pgx:22 `nC[nI-1]` in the first pass the index of `nC` is -1
              | run-time error 21: index negative
              ? the first index is 0
              > start.pgx:20 `0` the start of the counter
        "#]]
        .assert_eq(&program(
            "nI=0\ndo\nnX=nA[nI]\nnI=nI+1\nuntil nI>5\nnI=1\ndo\nnC[nI]=0\nnI=nI+1\nuntil nI>size(nC)\n\
             nI=0\ndo\nnX=nC[nI+1]\nnI=nI+1\nuntil nI==size(nC)\nnI=0\ndo\nnX=nC[nI-1]\nnI=nI+1\nuntil 3<=nI",
        ));
    }

    #[test]
    fn other_loops_with_the_condition_at_the_end_are_not_reported() {
        for code in [
            "nI=0\ndo\nnX=nA[nI]\nnI=nI+1\nuntil nI>4",
            "nI=0\ndo\nnX=nA[nI]\nnI=nI+1\nuntil nI>=size(nA)",
            "nI=0\ndo\nnX=nA[nI]\nnI=nI+1\nuntil nI==5",
            "nI=0.5\ndo\nnX=nA[nI]\nnI=nI+1\nuntil nI>5",
            "nI=0\nnX=1\ndo\nnX=nA[nI]\nnI=nI+1\nuntil nI>5",
            "if nX>0\nnI=0\nendIf\ndo\nnX=nA[nI]\nnI=nI+1\nuntil nI>5",
            "nI=0\ndo\nnI=nI+1\nnX=nA[nI-1]\nuntil nI>5",
            "nI=0\ndo\nnX=nA[nI]\nnI=nI+1\nuntil nI>5 or nX==3",
            "nI=0\ndo\nnX=nA[nI]\nif nX==3\nnI=9\nendIf\nnI=nI+1\nuntil nI>5",
            "nI=0\ndo\nif nX==3\nreturn\nendIf\nnX=nA[nI]\nnI=nI+1\nuntil nI>5",
            "nI=0\ndo\nif nI<5\nnX=nA[nI]\nendIf\nnI=nI+1\nuntil nI>5",
            "nI=7\ndo\nnI=nI+1\nuntil nI>5",
        ] {
            assert_eq!(program(code), "", "{code}");
        }
    }

    #[test]
    fn a_loop_whose_counter_a_called_program_may_change_is_not_reported() {
        let other = "program other()\nbegin\nnI=9\nend";
        for code in [
            "nI=0\ndo\nnX=nA[nI]\ncall other()\nnI=nI+1\nuntil nI>5",
            "while nI<=size(nA)\nnX=nA[nI]\ncall other()\nnI=nI+1\nendWhile",
            "for nI=0 to 5\nnX=nA[nI]\ncall other()\nendFor",
        ] {
            assert_eq!(program(&format!("{code}\n{other}")), "", "{code}");
        }
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
            "for nI=size(nA)-1 to 0 step -1\nputln(nA[nI])\nendFor",
            "for nI=size(nA) to 1 step -1\nputln(nA[nI-1])\nendFor",
            "for nI=0 to size(nA)-2\nputln(nA[nI+1])\nendFor",
            "for nI=2 to size(nC)\nputln(nC[nI])\nendFor",
            "for nI=0 to size(nC)-3\nputln(nC[nI+3])\nendFor",
            "for nI=3 to 5 step -1\nputln(nA[nI])\nendFor",
            "while nI<size(nC)\nputln(nC[nI])\nnI=nI+1\nendWhile",
            "for nI=0 to 3\nif nI>0\nputln(nA[nI-1])\nendIf\nendFor",
            "if size(nA)>5\nfor nI=0 to 5\nputln(nA[nI])\nendFor\nendIf",
            "if size(nA)<=nX\nreturn\nendIf\nfor nI=0 to 5\nputln(nA[nI])\nendFor",
            "if false\nfor nI=0 to size(nA)\nputln(nA[nI])\nendFor\nendIf",
        ] {
            assert_eq!(program(code), "", "{code}");
        }
    }
}
