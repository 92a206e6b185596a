//! Laws of the step mode: tasks cannot detect it, nothing hangs, a snapshot contains it.

use super::*;

/// Tasks cannot detect that they rest: neither a synchronous task, nor a task that reads the state of other tasks.
#[test]
fn tasks_do_not_notice_that_they_rest() {
    let listing = "\
num nOverrun
bool bLate
bool bOver
num nStatus
program start()
mdesc mDesc
begin
  mDesc.blend=off
  taskCreateSync \"sync\",0.004,bLate,watch()
  taskCreate \"other\",10,ask()
  movej({90,0,90,0,90,0},flange,mDesc)
  movej({0,0,90,0,90,0},flange,mDesc)
  waitEndMove()
  bOver=true
  ? nOverrun
  ? nStatus
end
program watch()
begin
  while bOver==false
    if bLate
      nOverrun=nOverrun+1
    endIf
    delay(0)
  endWhile
end
program ask()
begin
  while bOver==false
    if taskStatus(\"sync\")!=1 and taskStatus(\"main~\")!=1
      nStatus=nStatus+1
    endIf
    delay(0.004)
  endWhile
end
";
    let mut debugger = debugger(listing, MotionMode::Step);
    let mut stops = 0;
    while run(&mut debugger).is_some() {
        stops += 1;
    }
    let events = debugger.controller.devices.take_events();
    let printed = Running { controller: debugger.controller, events }.printed();
    assert_eq!((stops, printed.as_str()), (2, "0\n0\n"));
}

/// Any sequence of requests ends, and the arm ends at the program's last position.
#[test]
fn random_requests_never_hang() {
    for seed in 0..60_u64 {
        let mut debugger = debugger(&manual_with_wait(), MotionMode::Step);
        debugger.record(PastLimits::snapshots(20));
        let mut state = seed;
        let mut random = |most: u64| next_random(&mut state) % most;
        for _ in 0..30 {
            let Some(task) = debugger.controller.vm.tasks().first().map(|task| task.id) else { break };
            match random(10) {
                0 => debugger.set_motion_mode(MotionMode::Continuous),
                1 | 2 => debugger.set_motion_mode(MotionMode::Step),
                3 | 4 => debugger.step_motion(),
                5 => debugger.abandon_step(),
                6 => drop(debugger.step_back(task, StepKind::In)),
                7 => stop_at(&mut debugger, 3 + u32::try_from(random(8)).unwrap()),
                _ => debugger.step(task, [StepKind::In, StepKind::Over, StepKind::Out][random(3) as usize]),
            }
            for _ in 0..random(200) {
                match debugger.advance() {
                    AdvanceResult::Ran(status) if !status.is_final() => {}
                    _ => break,
                }
            }
        }
        debugger.set_motion_mode(MotionMode::Continuous);
        while run(&mut debugger).is_some() {}
        let end = debugger.controller.arm().joint();
        assert_eq!(end, [-30.0, 10.0, 80.0, 0.0, 90.0, 0.0], "{seed}");
    }
}

/// Next number of a linear congruential generator.
fn next_random(state: &mut u64) -> u64 {
    *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    *state >> 33
}

/// The mode and the releases are part of a snapshot.
#[test]
fn a_restored_controller_moves_in_the_same_way() {
    let mut debugger = debugger(MANUAL, MotionMode::Continuous);
    stop_at(&mut debugger, 9);
    run(&mut debugger).unwrap();
    let controller = &mut debugger.controller;
    controller.arm_mut().set_mode(MotionMode::Step);
    let waits = controller.snapshot();
    controller.arm_mut().release_piece();
    controller.step();
    let released = controller.snapshot();
    let (first, second) = (follow(controller, &released), follow(controller, &released));
    assert_eq!(first, second);
    assert!((first[199][0] - 24.792).abs() < 1e-3, "{:?}", first[199]);
    assert!(follow(controller, &waits).iter().all(|joint| *joint == READY));
}

/// Joint positions in the 200 cycles after a snapshot.
fn follow(controller: &mut Controller, snapshot: &Snapshot) -> Vec<[f64; 6]> {
    controller.restore(snapshot);
    let mut joints = Vec::new();
    for _ in 0..200 {
        controller.step();
        joints.push(controller.arm().joint());
    }
    joints
}
