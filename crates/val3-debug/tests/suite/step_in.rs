//! Steps into called programs and created tasks.

use std::fmt::Write as _;

use expect_test::expect;
use val3_debug::{StepInTarget, StepKind, Stop, StopErrors};

use crate::debugger::{debugger, run, set, shown};

const LEADING: &str = r#"
program start()
num l_nSum
begin
  l_nSum=1
  if l_nSum==1
    call add(l_nSum)
  endIf
  taskCreate "work",10,work()
  taskCreate "work",10,work()
  delay(1)
end

program add(num& x_nSum)
begin
  x_nSum=x_nSum+1
end

program work()
begin
  delay(2)
end
"#;

#[test]
fn a_line_leads_into_a_program_or_a_task() {
    let mut debugger = debugger(LEADING);
    let main = debugger.controller.vm.tasks()[0].id;
    let mut steps = String::new();
    for kind in [StepKind::Over, StepKind::Over, StepKind::In, StepKind::Out, StepKind::IntoTask] {
        debugger.step(main, kind);
        let stop = run(&mut debugger);
        let target = debugger.step_in_target(main);
        let target =
            target.map(|StepInTarget { application, program, kind }| format!("{application}:{program} {kind:?}"));
        writeln!(steps, "{}, then {}", shown(&debugger, stop), target.as_deref().unwrap_or("nowhere")).unwrap();
    }
    expect![[r#"
        step main~: start:2, then nowhere
        step main~: start:3, then main:add In
        step main~: add:1 < start:3, then nowhere
        step main~: start:5, then main:work IntoTask
        step work: work:1, then main:work IntoTask
    "#]]
    .assert_eq(&steps);
}

/// The name is in use: the line fails, and no task begins.
#[test]
fn a_line_that_creates_no_task_leads_nowhere() {
    let mut debugger = debugger(LEADING);
    let main = debugger.controller.vm.tasks()[0].id;
    debugger.set_errors(StopErrors::all());
    set(&mut debugger, "start", &[(6, None)]);
    run(&mut debugger);
    debugger.step(main, StepKind::IntoTask);
    assert!(matches!(run(&mut debugger), Some(Stop::Error { task, .. }) if task == main));
}
