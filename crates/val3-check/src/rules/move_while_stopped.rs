//! V0407: the program waits for an arm that it has stopped.

use rustc_hash::FxHashSet;
use val3_lang::motion::MotionRole;

use crate::diagnostic::Wording;
use crate::lint::{Findings, Phase, Program};
use crate::rule::rule;

rule! {
    /// A program stops the arm with `stopMove`, and then moves it or waits for it while it is still stopped.
    ///
    /// ## Why
    /// After `stopMove`, the arm continues only after `restartMove` or `resetMotion` (10.6). Until then a move
    /// instruction records its move, and the arm does not make it. `waitEndMove`, `open` and `close` wait for the arm
    /// to arrive, so they wait until another task lets it continue, or for ever.
    ///
    /// `restartMove` lets the arm finish the moves that were recorded, before and after the stop. `resetMotion` cancels
    /// them, so the next move starts from where the arm is.
    ///
    /// ## Bad
    /// ```val3
    /// joint jHome
    /// mdesc mSlow
    ///
    /// stopMove()
    /// movej(jHome,flange,mSlow)
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// joint jHome
    /// mdesc mSlow
    ///
    /// stopMove()
    /// resetMotion()
    /// movej(jHome,flange,mSlow)
    /// ```
    V0407 "move-while-stopped" Warning, Member: check
}

fn check(program: &Program<'_>, found: &mut Findings) {
    let mut told = FxHashSet::default();
    for step in program.motion_steps() {
        let Phase::Stopped(stop) = step.arm.phase else { continue };
        let needs_arm = matches!(step.role, MotionRole::Move(_) | MotionRole::Arrive);
        if needs_arm && told.insert(stop) {
            let is_move = step.role != MotionRole::Arrive;
            found
                .report(&RULE, program.range(step.call.id), word(step.call.instruction.name, is_move))
                .related(program.range(stop), "stopped here");
        }
    }
}

fn word(instruction: &str, is_move: bool) -> Wording {
    let message = if is_move {
        format!("the arm is stopped: what `{instruction}` records is not done")
    } else {
        format!("the arm is stopped: `{instruction}` waits for ever")
    };
    let help = "let the arm go on with `restartMove()`, or forget its moves with `resetMotion()`";
    Wording::new(message, "nothing has let the arm go on", help)
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    fn program(code: &str) -> String {
        format!("joint jA\ntool tA\nmdesc mA\nbool bA\n\n{code}\n\nprogram resume()\nbegin\n  restartMove()\nend")
    }

    #[test]
    fn stopped() {
        expect![[r#"
            start.pgx:7 `movej(jA,tA,mA)` the arm is stopped: what `movej` records is not done
              | nothing has let the arm go on
              ? let the arm go on with `restartMove()`, or forget its moves with `resetMotion()`
              > start.pgx:6 `stopMove()` stopped here
        "#]]
        .assert_eq(&check(&RULE, &program("stopMove()\nmovej(jA,tA,mA)\nwaitEndMove()")));
        expect![[r#"
            start.pgx:9 `waitEndMove()` the arm is stopped: `waitEndMove` waits for ever
              | nothing has let the arm go on
              ? let the arm go on with `restartMove()`, or forget its moves with `resetMotion()`
              > start.pgx:7 `stopMove()` stopped here
        "#]]
        .assert_eq(&check(&RULE, &program("movej(jA,tA,mA)\nstopMove()\nif isEmpty()\nwaitEndMove()\nendIf")));
    }

    #[test]
    fn set_free() {
        let lines =
            ["restartMove()", "resetMotion()", "resetMotion(jA)", "call resume()", "if bA\nrestartMove()\nendIf"];
        for line in lines {
            assert_eq!(
                check(&RULE, &program(&format!("stopMove()\n{line}\nmovej(jA,tA,mA)\nwaitEndMove()"))),
                "",
                "{line}"
            );
        }
        assert_eq!(check(&RULE, &program("movej(jA,tA,mA)\nstopMove()")), "");
    }
}
