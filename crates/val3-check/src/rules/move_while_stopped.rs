//! V0407: a wait for an arm that the program has stopped.

use rustc_hash::FxHashSet;
use val3_analysis::body::ExprId;
use val3_analysis::flow::{Facts, FlowNode, FlowNodeId, PointKind, backward};
use val3_lang::motion::MotionRole;

use crate::diagnostic::Wording;
use crate::lint::{ArmActivity, Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// A program stops the arm with `stopMove`, and then moves it or waits for it without restarting it.
    ///
    /// ## Why
    /// After `stopMove`, the arm continues only after `restartMove` or `resetMotion` (10.6). Until then a move
    /// instruction records its move, but the arm does not execute it. `waitEndMove`, `open` and `close` wait for the
    /// recorded moves, so they never return. The rule is silent where another task may call `restartMove`, and where no
    /// recorded move is left to wait for.
    ///
    /// After `restartMove` the arm finishes the recorded moves, before and after the stop. `resetMotion` cancels them,
    /// so the next move starts from where the arm is.
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

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    let mut told = FxHashSet::default();
    let mut freed = None;
    for step in program.arm_calls() {
        let ArmActivity::Stopped { by: stop, pending } = step.arm.phase else { continue };
        let is_move = step.role != MotionRole::Arrive;
        let is_stuck = match step.role {
            MotionRole::Move(_) => !is_freed(program, freed.get_or_insert_with(|| freed_later(program)), step.call.id),
            MotionRole::Arrive => pending,
            _ => false,
        };
        if is_stuck && !told.contains(&stop) && !others_restart(program) {
            told.insert(stop);
            found
                .report(&RULE, program.range(step.call.id), word(step.call.instruction.name, is_move))
                .related(program.range(stop), "stopped here");
        }
    }
}

/// Whether, before each flow node, the program may still restart the arm later, or call a program that may.
fn freed_later(program: &ProgramView<'_>) -> Facts<bool> {
    backward(
        program.flow(),
        false,
        |id, point, behind| *behind || may_restart(program, id, point),
        |known, more| {
            let news = *more && !*known;
            *known |= news;
            news
        },
    )
}

/// Whether the flow node restarts the arm, or calls a program that may.
fn may_restart(program: &ProgramView<'_>, id: FlowNodeId, point: &FlowNode) -> bool {
    let mut roles = program.calls_at(id).iter().filter_map(|call| call.role);
    matches!(point.kind, PointKind::Call(_))
        || roles.any(|role| matches!(role, MotionRole::Restart | MotionRole::Reset))
}

fn is_freed(program: &ProgramView<'_>, freed: &Facts<bool>, call: ExprId) -> bool {
    let point = program.motion().and_then(|motion| motion.point_of(call));
    point.and_then(|point| freed.before(point)).copied().unwrap_or(true)
}

/// Whether another program, which a task may run meanwhile, calls `restartMove`.
fn others_restart(program: &ProgramView<'_>) -> bool {
    let application = program.application();
    application.restarting.iter().any(|name| name != program.name() && application.run_by.contains_key(name))
}

fn word(instruction: &str, is_move: bool) -> Wording {
    let message = if is_move {
        format!("the arm is stopped: it does not execute this `{instruction}`")
    } else {
        format!("the arm is stopped: `{instruction}` never returns")
    };
    let help = "let the arm continue with `restartMove()`, or delete its moves with `resetMotion()`";
    Wording::new(message, "nothing has restarted the arm", help)
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
    fn moves_after_stop_move_are_reported() {
        expect![[r#"
            start.pgx:7 `movej(jA,tA,mA)` the arm is stopped: it does not execute this `movej`
              | nothing has restarted the arm
              ? let the arm continue with `restartMove()`, or delete its moves with `resetMotion()`
              > start.pgx:6 `stopMove()` stopped here
        "#]]
        .assert_eq(&check(&RULE, &program("stopMove()\nmovej(jA,tA,mA)\nwaitEndMove()")));
        expect![[r#"
            start.pgx:9 `waitEndMove()` the arm is stopped: `waitEndMove` never returns
              | nothing has restarted the arm
              ? let the arm continue with `restartMove()`, or delete its moves with `resetMotion()`
              > start.pgx:7 `stopMove()` stopped here
        "#]]
        .assert_eq(&check(&RULE, &program("movej(jA,tA,mA)\nstopMove()\nif bA\nwaitEndMove()\nendIf")));
    }

    #[test]
    fn a_stop_without_pending_move_is_not_reported() {
        let lines = [
            "stopMove()\nwaitEndMove()",
            "stopMove()\nopen(tA)",
            "movej(jA,tA,mA)\nwaitEndMove()\nstopMove()\nwaitEndMove()",
            "movej(jA,tA,mA)\ndelay(1)\nstopMove()\nwaitEndMove()",
            "if bA\nmovej(jA,tA,mA)\nendIf\nstopMove()\nwaitEndMove()",
            "movej(jA,tA,mA)\nstopMove()\nif isEmpty()\nwaitEndMove()\nendIf",
            "movej(jA,tA,mA)\nresetMotion()\nstopMove()\nclose(tA)",
        ];
        for line in lines {
            assert_eq!(check(&RULE, &program(line)), "", "{line}");
        }
    }

    #[test]
    fn a_restart_after_the_move_is_not_reported() {
        let lines = ["restartMove()", "if bA\nrestartMove()\nendIf", "call resume()", "resetMotion()"];
        for line in lines {
            assert_eq!(check(&RULE, &program(&format!("stopMove()\nmovej(jA,tA,mA)\n{line}"))), "", "{line}");
        }
        // The wait comes first, so that the next line is never reached.
        expect![[r#"
            start.pgx:8 `waitEndMove()` the arm is stopped: `waitEndMove` never returns
              | nothing has restarted the arm
              ? let the arm continue with `restartMove()`, or delete its moves with `resetMotion()`
              > start.pgx:6 `stopMove()` stopped here
        "#]]
        .assert_eq(&check(&RULE, &program("stopMove()\nmovej(jA,tA,mA)\nwaitEndMove()\nrestartMove()")));
    }

    #[test]
    fn a_restart_by_another_task_counts() {
        let other = "\n\nprogram watch()\nbegin\n  call resume()\nend";
        let task = |program_name: &str| format!("taskCreate \"t\",10,{program_name}()\n");
        let code = "movej(jA,tA,mA)\nstopMove()\nwaitEndMove()";
        for name in ["resume", "watch"] {
            assert_eq!(check(&RULE, &(program(&(task(name) + code)) + other)), "", "{name}");
        }
        assert_ne!(check(&RULE, &(program(code) + other)), "");
    }

    #[test]
    fn a_restart_before_the_move_is_not_reported() {
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
