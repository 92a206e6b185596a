//! V0414: the application ends with a move for which nothing waits.

use rustc_hash::FxHashSet;
use val3_analysis::application::{START, STOP};
use val3_analysis::flow::{FlowNodeId, PointKind};

use crate::diagnostic::Wording;
use crate::lint::{ArmActivity, Findings, ProgramView, is_library};
use crate::rule::rule;

rule! {
    /// The application ends after a move that nothing waits for.
    ///
    /// ## Why
    /// A move instruction only records a move, and the program continues immediately (10.2). The application ends with
    /// its last task (2.1.3), and the arm with it: `start` is over within some milliseconds, and the recorded moves are
    /// not executed. The rule reports the last move of `start` if no line after it waits, the application has no other
    /// task, and its program `stop` does not wait either.
    ///
    /// ## Bad
    /// ```val3
    /// joint jReady
    /// tool tGripper
    /// mdesc mFast
    ///
    /// program start()
    /// begin
    ///   movej(jReady,tGripper,mFast)
    /// end
    ///
    /// program stop()
    /// begin
    /// end
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// joint jReady
    /// tool tGripper
    /// mdesc mFast
    ///
    /// program start()
    /// begin
    ///   movej(jReady,tGripper,mFast)
    ///   waitEndMove()
    /// end
    ///
    /// program stop()
    /// begin
    /// end
    /// ```
    V0414 "move-not-awaited" Warning, Member: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    if program.name() != START || !ends_application(program) {
        return;
    }
    let Some(motion) = program.motion() else { return };
    let end = program.flow().points().find(|(_, point)| point.kind == PointKind::End);
    let Some((end, _)) = end else { return };
    let arm = motion.arm(end);
    let (ArmActivity::Moving, Some(last)) = (arm.phase, arm.last) else { return };
    let may_poll = motion.point_of(last).is_none_or(|point| leads_to_loop(program, point));
    if let Some(call) = program.call_of(last).filter(|_| !may_poll) {
        found.report(&RULE, program.range(last), word(call.instruction.name));
    }
}

/// Whether the application ends when `start` ends, without time for the arm after that.
fn ends_application(program: &ProgramView<'_>) -> bool {
    let application = program.application();
    let has_stop = program.items.programs.contains_key(STOP);
    application.sound
        && has_stop
        && application.created_tasks().next().is_none()
        && !application.waiting.contains(STOP)
        && !application.callers.contains_key(START)
        && !is_library(program.db, program.project)
}

/// Whether a loop with a condition, which may run until the arm has arrived, can follow a flow node.
fn leads_to_loop(program: &ProgramView<'_>, from: FlowNodeId) -> bool {
    let mut seen = FxHashSet::default();
    let mut open = vec![from];
    while let Some(id) = open.pop() {
        let Some(point) = program.flow().point(id).filter(|_| seen.insert(id)) else { continue };
        if matches!(point.kind, PointKind::Test { is_loop: true, .. }) {
            return true;
        }
        open.extend(point.next.iter().copied());
    }
    false
}

fn word(instruction: &str) -> Wording {
    Wording::new(
        format!("the application ends before the arm has executed this `{instruction}`"),
        "nothing waits for this move",
        "call `waitEndMove()` at the end of `start`",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    fn found(start: &str, others: &str) -> String {
        let code = format!(
            "joint jA\ntool tA\nmdesc mA\nbool bA\n\nprogram start()\nbegin\n{start}\nend\nprogram stop()\nbegin\nend\n\
             program work()\nbegin\n  waitEndMove()\nend\n{others}"
        );
        check(&RULE, &code)
    }

    const MOVE: &str = "  movej(jA,tA,mA)\n";

    #[test]
    fn a_last_move_that_nothing_waits_for_is_reported() {
        expect![[r#"
            start.pgx:7 `movej(jA,tA,mA)` the application ends before the arm has executed this `movej`
              | nothing waits for this move
              ? call `waitEndMove()` at the end of `start`
        "#]]
        .assert_eq(&found(&format!("  waitEndMove()\n{MOVE}{MOVE}"), ""));
        assert_eq!(found(&format!("{MOVE}  jA=herej()\n  putln(\"moved\")"), "").lines().count(), 3);
    }

    #[test]
    fn a_move_that_may_be_executed_is_not_reported() {
        let after = [
            "  waitEndMove()",
            "  wait(isEmpty())",
            "  open(tA)",
            "  delay(1)",
            "  call work()",
            "  while !isEmpty()\n  endWhile",
            "  while clock()<5\n  endWhile",
            "  if bA\n    waitEndMove()\n  endIf",
            "  while true\n  delay(0)\n  endWhile",
            "  taskCreate \"work\",10,work()",
            "  resetMotion()",
        ];
        for after in after {
            assert_eq!(found(&format!("{MOVE}{after}"), ""), "", "{after}");
        }
        assert_eq!(found(&format!("  if bA\n    return\n  endIf\n{MOVE}"), ""), "", "start may end before the move");
        assert_eq!(found(MOVE, "program again()\nbegin\n  call start()\nend"), "", "start is called");
        let waits = format!(
            "joint jA\ntool tA\nmdesc mA\n\nprogram start()\nbegin\n{MOVE}end\nprogram stop()\nbegin\n  waitEndMove()\nend"
        );
        assert_eq!(check(&RULE, &waits), "", "stop waits");
        let library = format!("joint jA\ntool tA\nmdesc mA\n\nprogram start()\nbegin\n{MOVE}end");
        assert_eq!(check(&RULE, &library), "", "a project without stop is no application");
    }
}
