//! V0308: a loop without end in which nothing waits.

use val3_analysis::body::{Expr, ExprId, StmtKind};
use val3_analysis::flow::{FlowNode, FlowNodeId, PointKind};
use val3_lang::instructions::{CLOCK, DELAY};

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// An endless loop contains no line that ends the task's turn early.
    ///
    /// ## Why
    /// Such a loop uses up every turn of its task. Other tasks, the pendant and the network become slow, and a
    /// synchronous task overruns its period. A `delay(0)` ends the turn; a longer delay or a `wait` for the event is
    /// better.
    ///
    /// ## Bad
    /// ```val3
    /// dio diDoor
    /// dio doLamp
    ///
    /// while true
    ///   doLamp=(diDoor==true)
    /// endWhile
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// dio diDoor
    /// dio doLamp
    ///
    /// while true
    ///   doLamp=(diDoor==true)
    ///   delay(0.02)
    /// endWhile
    /// ```
    V0308 "loop-never-waits" Warning, Member: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    for stmt in program.stmts() {
        let Some(condition) = program.endless_condition(stmt) else { continue };
        let inside = || program.flow().points().filter(|(_, point)| stmt.range.contains_range(point.range));
        if !stmt.holds(&StmtKind::Return) && !inside().any(|(id, point)| waits(program, id, point)) {
            let reported = found.report(&RULE, program.range(condition), word(is_synchronous(program)));
            if let Some(last) = stmt.blocks().next().and_then(<[_]>::last) {
                let edit = program.site(last.range).line_after(&format!("{DELAY}(0)"));
                reported.fix("let other tasks run in each round", false, [edit]);
            }
        }
    }
}

/// Whether other tasks may run at this flow node, or the clock limits the loop's speed.
fn waits(program: &ProgramView<'_>, id: FlowNodeId, point: &FlowNode) -> bool {
    program.effects.may_wait_at(point)
        || program.calls_at(id).iter().any(|call| call.instruction.name == CLOCK)
        || matches!(point.kind, PointKind::Call(call) if may_wait(program, call))
}

fn may_wait(program: &ProgramView<'_>, call: ExprId) -> bool {
    let Expr::Call(callee, _) = program.body.expr(call) else { return true };
    match program.body.expr(*callee) {
        Expr::Name(name) => program.application().waiting.contains(name),
        _ => true,
    }
}

fn is_synchronous(program: &ProgramView<'_>) -> bool {
    program.application().tasks_of(program.name()).any(|task| task.start.synchronous)
}

fn word(is_synchronous: bool) -> Wording {
    let message = if is_synchronous {
        "nothing in this endless loop waits: the synchronous task overruns every period"
    } else {
        "nothing in this endless loop waits: it uses up every turn of its task, and other tasks become slow"
    };
    Wording::new(message, "loops without a pause", "end each round with `delay(…)`, or `wait(…)` for an event")
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::fix_testing::fixed;
    use crate::lint::testing::check;

    #[test]
    fn loops_without_a_pause_are_reported() {
        expect![[r#"
            start.pgx:6 `true` nothing in this endless loop waits: it uses up every turn of its task, and other tasks become slow
              | loops without a pause
              ? end each round with `delay(…)`, or `wait(…)` for an event
              ! let other tasks run in each round (unsafe)
        "#]]
        .assert_eq(&check(
            &RULE,
            "num n\n\nwhile true\nn=n+1\ncall add()\nendWhile\n\nprogram add()\nbegin\n  n=n+2\nend",
        ));
        expect![[r#"
            start.pgx:7 `false` nothing in this endless loop waits: it uses up every turn of its task, and other tasks become slow
              | loops without a pause
              ? end each round with `delay(…)`, or `wait(…)` for an event
              ! let other tasks run in each round (unsafe)
        "#]]
        .assert_eq(&check(&RULE, "num n\ndo\nn=n+1\nuntil false"));
    }

    #[test]
    fn the_fix_adds_a_delay() {
        expect![[r#"
            while true
              if n>1
                n=0
              endIf
              delay(0)
            endWhile
            end"#]]
        .assert_eq(&fixed(&RULE, "num n\nwhile true\n  if n>1\n    n=0\n  endIf\nendWhile"));
    }

    #[test]
    fn the_message_says_that_a_synchronous_task_overruns() {
        let main = "num n\nbool b\n\ntaskCreateSync \"t\",0.02,b,turn()\n\nprogram turn()\nbegin\n  while true\n    ";
        expect![[r#"
            turn.pgx:5 `true` nothing in this endless loop waits: the synchronous task overruns every period
              | loops without a pause
              ? end each round with `delay(…)`, or `wait(…)` for an event
              ! let other tasks run in each round (unsafe)
        "#]]
        .assert_eq(&check(&RULE, &format!("{main}n=n+1\n  endWhile\nend")));
        assert_eq!(check(&RULE, &format!("{main}delay(0)\n  endWhile\nend")), "");
    }

    #[test]
    fn loops_with_a_pause_are_not_reported() {
        let lines =
            ["delay(0)", "b=watch(d,1)", "s=line", "line=s", "n=clock()", "n=get()", "setMutex(b)", "call rest()"];
        for line in lines {
            let data = "num n\nbool b\ndio d\nstring s\nsio line\n";
            let rest = "program rest()\nbegin\n  call more()\nend\n\nprogram more()\nbegin\n  delay(1)\nend";
            assert_eq!(check(&RULE, &format!("{data}\nwhile true\nn=n+1\n{line}\nendWhile\n\n{rest}")), "", "{line}");
        }
    }

    #[test]
    fn a_loop_that_ends_is_not_reported() {
        assert_eq!(check(&RULE, "num n\nwhile true\nn=n+1\nif n>9\nreturn\nendIf\nendWhile"), "");
        assert_eq!(check(&RULE, "num n\nwhile n<9\nn=n+1\nendWhile"), "");
    }
}
