//! V0417: a move that the next line discards.

use val3_analysis::body::{Stmt, StmtKind};
use val3_lang::instructions::{DISABLE_POWER, RESET_MOTION, WAIT_END_MOVE};
use val3_lang::motion::MotionRole;

use crate::diagnostic::Wording;
use crate::lint::{Call, Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// `resetMotion` or `disablePower` directly follows a move.
    ///
    /// ## Why
    /// A move is only recorded: the program continues immediately, far ahead of the arm (10.2). `resetMotion` cancels
    /// the move, and without power the arm stops, so the arm does not reach the target.
    ///
    /// ## Bad
    /// ```val3
    /// point pHome
    /// tool tGripper
    /// mdesc mSlow
    ///
    /// movel(pHome,tGripper,mSlow)
    /// disablePower()
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// point pHome
    /// tool tGripper
    /// mdesc mSlow
    ///
    /// movel(pHome,tGripper,mSlow)
    /// waitEndMove()
    /// disablePower()
    /// ```
    V0417 "discarded-move" Warning, Program: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    if [RESET_MOTION, DISABLE_POWER].iter().all(|name| program.calls_of(name).next().is_none()) {
        return;
    }
    for block in program.body.blocks() {
        for (line, next) in block.iter().zip(block.iter().skip(1)) {
            let Some(ends) = statement(program, next) else { continue };
            let is_end = [RESET_MOTION, DISABLE_POWER].contains(&ends.instruction.name);
            let moves = statement(program, line).filter(|call| matches!(call.role, Some(MotionRole::Move(_))));
            let Some(moves) = moves.filter(|_| is_end) else { continue };
            let target = program.target(moves.id).map_or("its target", |target| program.text(target));
            found
                .report(&RULE, program.range(moves.id), word(target, ends.instruction.name))
                .related(program.range(ends.id), "the arm only starts before this line")
                .fix("wait for the arm", false, [program.site(next.range).line_before(&format!("{WAIT_END_MOVE}()"))]);
        }
    }
}

/// Instruction call that is a statement, or an assignment's value.
fn statement<'p>(program: &'p ProgramView<'_>, stmt: &Stmt) -> Option<&'p Call<'p>> {
    let call = match stmt.kind {
        StmtKind::Expr(call) => call,
        StmtKind::Assign { value, .. } => value,
        _ => return None,
    };
    program.call_of(program.body.without_parentheses(call))
}

fn word(target: &str, next: &str) -> Wording {
    Wording::new(
        format!("the arm does not reach `{target}`: the next line is `{next}`"),
        "the move is discarded",
        "call `waitEndMove()` between both lines",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    fn program(code: &str) -> String {
        check(&RULE, &format!("point pA\ntool tA\nmdesc mA\nnum nA\n{code}"))
    }

    #[test]
    fn moves_before_a_reset_are_reported() {
        expect![[r#"
            start.pgx:5 `movel(pA,tA,mA)` the arm does not reach `pA`: the next line is `resetMotion`
              | the move is discarded
              ? call `waitEndMove()` between both lines
              > start.pgx:6 `resetMotion()` the arm only starts before this line
              ! wait for the arm (unsafe)
            start.pgx:7 `movej(pA,tA,mA)` the arm does not reach `pA`: the next line is `disablePower`
              | the move is discarded
              ? call `waitEndMove()` between both lines
              > start.pgx:8 `disablePower()` the arm only starts before this line
              ! wait for the arm (unsafe)
        "#]]
        .assert_eq(&program("nA=movel(pA,tA,mA)\nresetMotion()\nmovej(pA,tA,mA)\ndisablePower()"));
    }

    #[test]
    fn other_moves_are_not_reported() {
        assert_eq!(program("movel(pA,tA,mA)\nwaitEndMove()\nresetMotion()"), "");
        assert_eq!(program("movel(pA,tA,mA)\ndelay(1)\nresetMotion()"), "");
        assert_eq!(program("movel(pA,tA,mA)\nstopMove()\nresetMotion()"), "");
    }
}
