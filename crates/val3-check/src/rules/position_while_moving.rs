//! V0408: a position that is stored while the arm is moving.

use val3_analysis::flow::PointKind;
use val3_lang::instructions::WAIT_END_MOVE;
use val3_lang::motion::MotionRole;

use crate::diagnostic::Wording;
use crate::lint::{ArmActivity, Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// The position of the arm is stored directly after a move, without a `waitEndMove` between them.
    ///
    /// ## Why
    /// A move is only recorded: the program continues immediately (10.2). The stored position is somewhere near the
    /// start of the move and differs each time. Reading the position in a condition to follow the arm is usual and not
    /// reported.
    ///
    /// ## Bad
    /// ```val3
    /// point pPart
    /// point pFound
    /// tool tProbe
    /// mdesc mSlow
    ///
    /// movel(pPart,tProbe,mSlow)
    /// pFound=here(tProbe,world)
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// point pPart
    /// point pFound
    /// tool tProbe
    /// mdesc mSlow
    ///
    /// movel(pPart,tProbe,mSlow)
    /// waitEndMove()
    /// pFound=here(tProbe,world)
    /// ```
    V0408 "position-while-moving" Info, Member: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    let Some(motion) = program.motion() else { return };
    let wait = format!("{WAIT_END_MOVE}()");
    for (id, point) in program.flow().points() {
        let arm = motion.arm(id);
        let PointKind::Assign { .. } = point.kind else { continue };
        let Some(last) = arm.last.filter(|_| arm.phase == ArmActivity::Moving) else { continue };
        let read = program.calls_at(id).iter().find(|call| call.role == Some(MotionRole::Position));
        if let Some(read) = read {
            found
                .report(&RULE, program.range(read.id), word(read.instruction.name))
                .related(program.range(last), "the arm only starts here")
                .fix("wait for the arm", false, [program.site(point.range).line_before(&wait)]);
        }
    }
}

fn word(instruction: &str) -> Wording {
    Wording::new(
        format!("`{instruction}` reads the position while the arm is still moving"),
        "some position on the way",
        "if the end of the move is meant, call `waitEndMove()` before this line",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    fn program(code: &str) -> String {
        format!("point pA\njoint jA\ntool tA\nmdesc mA\nnum nA\n\nmovel(pA,tA,mA)\n{code}")
    }

    #[test]
    fn a_position_read_during_a_move_is_reported() {
        expect![[r#"
            start.pgx:7 `herej()` `herej` reads the position while the arm is still moving
              | some position on the way
              ? if the end of the move is meant, call `waitEndMove()` before this line
              > start.pgx:6 `movel(pA,tA,mA)` the arm only starts here
              ! wait for the arm (unsafe)
            start.pgx:8 `here(tA,world)` `here` reads the position while the arm is still moving
              | some position on the way
              ? if the end of the move is meant, call `waitEndMove()` before this line
              > start.pgx:6 `movel(pA,tA,mA)` the arm only starts here
              ! wait for the arm (unsafe)
        "#]]
        .assert_eq(&check(&RULE, &program("jA=herej()\nnA=distance(here(tA,world),pA)")));
    }

    #[test]
    fn a_position_read_at_standstill_is_not_reported() {
        let lines = [
            "waitEndMove()\njA=herej()",
            "wait(distance(here(tA,world),pA)<10)",
            "while distance(here(tA,world),pA)>10\ndelay(0)\njA=herej()\nendWhile",
            "nA=getMoveId()\njA=herej()",
        ];
        for line in lines {
            assert_eq!(check(&RULE, &program(line)), "", "{line}");
        }
    }
}
