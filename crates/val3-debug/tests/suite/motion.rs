//! Step mode of the motion (10.2.2), with programs. The arm is a TX2-90.

use expect_test::{Expect, expect};
use val3_debug::{AdvanceResult, Breakpoint, BreakpointId, Debugger, MotionStop, PastLimits, StepKind, Stop, frames};
use val3_lang::ports::TaskNumber;
use val3_machine::arm::{ArmHold, MotionMode, MoveStage};
use val3_machine::controller::{BlendPoint, Controller, RunStatus, Snapshot};
use val3_session::Pace;
use val3_tests::running::Running;

mod laws;

const READY: [f64; 6] = [0.0, 0.0, 90.0, 0.0, 90.0, 0.0];

/// The four moves of 10.2.2. Lines are counted from the line after `begin`.
const MANUAL: &str = "\
program start()
mdesc mDesc
joint jA
joint jB
joint jC
joint jD
begin
  jA={30,10,80,0,90,0}
  jB={30,-10,100,0,90,0}
  jC={-30,-10,100,0,90,0}
  jD={-30,10,80,0,90,0}
  movej(jA,flange,mDesc)
  movej(jB,flange,mDesc)
  movej(jC,flange,mDesc)
  movej(jD,flange,mDesc)
  waitEndMove()
  ? \"end\"
end
";

/// [`MANUAL`] with a `waitEndMove` after the second move (10.2.3).
fn manual_with_wait() -> String {
    MANUAL.replace("  movej(jC", "  waitEndMove()\n  movej(jC")
}

/// Creates a debugger at the beginning of the application, with the arm ready and powered.
fn debugger(listing: &str, mode: MotionMode) -> Debugger {
    let mut controller = Running::start(listing).controller;
    controller.devices.state.robot.set_power(true);
    controller.arm_mut().put(READY);
    let mut debugger = Debugger::new(controller);
    debugger.set_motion_mode(mode);
    debugger
}

fn first_row(debugger: &Debugger, program: &str) -> u32 {
    let (_, application) = debugger.controller.vm.space.loaded().next().unwrap();
    let number = application.image.program(program).unwrap();
    application.image.programs[usize::from(number)].lines[0].row
}

/// Sets a breakpoint on a line of `start`.
fn stop_at(debugger: &mut Debugger, line: u32) {
    let (_, application) = debugger.controller.vm.space.loaded().next().unwrap();
    let number = application.image.program("start").unwrap();
    let file = application.image.files[application.image.programs[usize::from(number)].file as usize].clone();
    let row = first_row(debugger, "start") + line - 1;
    debugger.set_breakpoints(&file, vec![Breakpoint::new(BreakpointId(0), row)]);
}

/// Runs to the next stop or to the end.
fn run(debugger: &mut Debugger) -> Option<Stop> {
    for _ in 0..100_000 {
        match debugger.advance() {
            AdvanceResult::Stopped(stop) => return Some(stop),
            AdvanceResult::Ran(RunStatus::Waiting(wake)) => {
                Pace::default().wait(&mut debugger.controller, wake)?;
            }
            AdvanceResult::Ran(status) if status.is_final() => return None,
            AdvanceResult::Ran(_) => {}
        }
    }
    panic!("it does not stop");
}

/// Formats the location of the first task, the position of the arm and the reason for the stop.
fn shown(debugger: &Debugger, stop: Option<&Stop>) -> String {
    let row = |program: &str, row: u32| format!("{program}:{}", row + 1 - first_row(debugger, program));
    let task = debugger.controller.vm.tasks().first().map(|task| task.id);
    let frames: Vec<_> = task.map(|task| frames(&debugger.controller.vm, task)).unwrap_or_default();
    let at = frames.first().map_or_else(String::new, |frame| row(&frame.program, frame.row));
    let Some(stop) = stop else { return format!("end {:.3?}", debugger.controller.arm().joint()) };
    let why = match stop {
        Stop::Motion(motion) => {
            let MotionStop { piece, has_next, hold, .. } = motion.as_ref();
            let piece = piece.as_ref().map_or_else(
                || "no piece".to_owned(),
                |found| {
                    let source = found.source.as_ref().unwrap();
                    let of = row(&source.program, source.line);
                    format!("{:?} of {} {of} to {:?}", found.piece.kind, source.instruction, found.piece.end)
                },
            );
            let more = if *has_next { ", more" } else { "" };
            format!("{piece}{more}{}", hold.map_or_else(String::new, |hold| format!(", {hold:?}")))
        }
        Stop::Step { .. } => "step".to_owned(),
        Stop::Breakpoints { .. } => "breakpoint".to_owned(),
        stop => format!("{stop:?}"),
    };
    format!("{at} {:.3?} {why}", debugger.controller.arm().joint())
}

/// Checks the stops of a run that calls `then` after each stop.
fn stops(debugger: &mut Debugger, mut then: impl FnMut(&mut Debugger, &Stop), expected: Expect) {
    let mut all = String::new();
    for _ in 0..40 {
        let stop = run(debugger);
        all += &(shown(debugger, stop.as_ref()) + "\n");
        let Some(stop) = stop else { break };
        then(debugger, &stop);
    }
    expected.assert_eq(&all);
}

fn task(debugger: &Debugger) -> TaskNumber {
    debugger.controller.vm.tasks()[0].id
}

#[test]
fn a_continued_run_stops_after_each_move() {
    stops(
        &mut debugger(MANUAL, MotionMode::Step),
        |_, _| (),
        expect![[r#"
        start:6 [24.792, 8.264, 81.736, 0.000, 90.000, 0.000] Nominal of movej start:5 to Leave
        start:7 [30.000, -3.255, 93.255, 0.000, 90.000, 0.000] Nominal of movej start:6 to Leave
        start:8 [-22.910, -10.000, 100.000, 0.000, 90.000, 0.000] Nominal of movej start:7 to Leave
        start:9 [-30.000, 3.255, 86.745, 0.000, 90.000, 0.000] Nominal of movej start:8 to Leave
        start:9 [-30.000, 10.000, 80.000, 0.000, 90.000, 0.000] Nominal of movej start:8 to Target
        end [-30.000, 10.000, 80.000, 0.000, 90.000, 0.000]
    "#]],
    );
}

#[test]
fn waiting_for_the_end_of_a_move_cancels_its_blend() {
    stops(
        &mut debugger(&manual_with_wait(), MotionMode::Step),
        |_, _| (),
        expect![[r#"
        start:6 [24.792, 8.264, 81.736, 0.000, 90.000, 0.000] Nominal of movej start:5 to Leave
        start:7 [30.000, -3.255, 93.255, 0.000, 90.000, 0.000] Nominal of movej start:6 to Leave
        start:7 [30.000, -10.000, 100.000, 0.000, 90.000, 0.000] Nominal of movej start:6 to Target
        start:9 [-22.910, -10.000, 100.000, 0.000, 90.000, 0.000] Nominal of movej start:8 to Leave
        start:10 [-30.000, 3.255, 86.745, 0.000, 90.000, 0.000] Nominal of movej start:9 to Leave
        start:10 [-30.000, 10.000, 80.000, 0.000, 90.000, 0.000] Nominal of movej start:9 to Target
        end [-30.000, 10.000, 80.000, 0.000, 90.000, 0.000]
    "#]],
    );
}

#[test]
fn without_a_blend_each_move_is_done_at_its_target() {
    let listing = MANUAL.replace("  jA={", "  mDesc.blend=off\n  jA={");
    stops(
        &mut debugger(&listing, MotionMode::Step),
        |_, _| (),
        expect![[r#"
        start:7 [30.000, 10.000, 80.000, 0.000, 90.000, 0.000] Nominal of movej start:6 to Target
        start:8 [30.000, -10.000, 100.000, 0.000, 90.000, 0.000] Nominal of movej start:7 to Target
        start:9 [-30.000, -10.000, 100.000, 0.000, 90.000, 0.000] Nominal of movej start:8 to Target
        start:10 [-30.000, 10.000, 80.000, 0.000, 90.000, 0.000] Nominal of movej start:9 to Target
        end [-30.000, 10.000, 80.000, 0.000, 90.000, 0.000]
    "#]],
    );
}

#[test]
fn a_step_over_a_move_ends_when_the_arm_has_arrived() {
    let mut debugger = debugger(&manual_with_wait(), MotionMode::Step);
    stop_at(&mut debugger, 5);
    let step = |debugger: &mut Debugger, _: &Stop| debugger.step(task(debugger), StepKind::Over);
    stops(
        &mut debugger,
        step,
        expect![[r#"
        start:5 [0.000, 0.000, 90.000, 0.000, 90.000, 0.000] breakpoint
        start:6 [24.792, 8.264, 81.736, 0.000, 90.000, 0.000] step
        start:7 [30.000, -3.255, 93.255, 0.000, 90.000, 0.000] step
        start:8 [30.000, -10.000, 100.000, 0.000, 90.000, 0.000] step
        start:9 [-22.910, -10.000, 100.000, 0.000, 90.000, 0.000] step
        start:10 [-30.000, 3.255, 86.745, 0.000, 90.000, 0.000] step
        start:11 [-30.000, 10.000, 80.000, 0.000, 90.000, 0.000] step
        end [-30.000, 10.000, 80.000, 0.000, 90.000, 0.000]
    "#]],
    );
}

/// The arm passes all points within a program that is stepped over, and no task continues before the arm has arrived.
#[test]
fn a_step_over_a_call_waits_for_each_move_in_it() {
    let listing = "\
program start()
mdesc mDesc
joint jA
begin
  taskCreate \"other\",10,count()
  jA={30,10,80,0,90,0}
  call go(jA,mDesc)
  bOver=true
  ? nCount
end

program go(joint x_jA,mdesc x_mDesc)
begin
  movej(x_jA,flange,x_mDesc)
  ? \"moved\"
  movej({0,0,90,0,90,0},flange,x_mDesc)
  waitEndMove()
end

program count()
begin
  while bOver==false
    nCount=nCount+1
    delay(0.004)
  endWhile
end
";
    let listing = format!("num nCount\nbool bOver\n{listing}");
    let mut debugger = debugger(&listing, MotionMode::Step);
    stop_at(&mut debugger, 2);
    let step = |debugger: &mut Debugger, _: &Stop| debugger.step(task(debugger), StepKind::Over);
    stops(
        &mut debugger,
        step,
        expect![[r#"
        start:2 [0.000, 0.000, 90.000, 0.000, 90.000, 0.000] breakpoint
        start:3 [0.000, 0.000, 90.000, 0.000, 90.000, 0.000] step
        start:4 [0.000, 0.000, 90.000, 0.000, 90.000, 0.000] step
        start:5 [0.000, 0.000, 90.000, 0.000, 90.000, 0.000] step
        end [0.000, 0.000, 90.000, 0.000, 90.000, 0.000]
    "#]],
    );
    let events = debugger.controller.devices.take_events();
    let printed = Running { controller: debugger.controller, events }.printed();
    // The other task counts each cycle in which it runs.
    let cycles: u32 = printed.lines().last().unwrap().parse().unwrap();
    assert!(printed.starts_with("moved\n") && cycles < 20, "{printed}");
}

#[test]
fn the_motion_steps_piece_by_piece() {
    let mut debugger = debugger(MANUAL, MotionMode::Continuous);
    stop_at(&mut debugger, 9);
    run(&mut debugger).unwrap();
    debugger.set_motion_mode(MotionMode::Step);
    let mut all = String::new();
    for _ in 0..9 {
        debugger.step_motion();
        let stop = run(&mut debugger);
        all += &(shown(&debugger, stop.as_ref()) + "\n");
    }
    expect![[r#"
        start:9 [24.792, 8.264, 81.736, 0.000, 90.000, 0.000] Nominal of movej start:5 to Leave, more
        start:9 [30.000, 3.255, 86.745, 0.000, 90.000, 0.000] Blend of movej start:5 to Reach, more
        start:9 [30.000, -3.255, 93.255, 0.000, 90.000, 0.000] Nominal of movej start:6 to Leave, more
        start:9 [22.910, -10.000, 100.000, 0.000, 90.000, 0.000] Blend of movej start:6 to Reach, more
        start:9 [-22.910, -10.000, 100.000, 0.000, 90.000, 0.000] Nominal of movej start:7 to Leave, more
        start:9 [-30.000, -3.255, 93.255, 0.000, 90.000, 0.000] Blend of movej start:7 to Reach, more
        start:9 [-30.000, 3.255, 86.745, 0.000, 90.000, 0.000] Nominal of movej start:8 to Leave
        start:9 [-30.000, 3.255, 86.745, 0.000, 90.000, 0.000] Nominal of movej start:8 to Leave
        start:9 [-30.000, 3.255, 86.745, 0.000, 90.000, 0.000] Nominal of movej start:8 to Leave
    "#]]
    .assert_eq(&all);
}

#[test]
fn nothing_moves_in_step_mode_without_a_release() {
    let mut debugger = debugger(MANUAL, MotionMode::Continuous);
    stop_at(&mut debugger, 9);
    run(&mut debugger).unwrap();
    debugger.set_motion_mode(MotionMode::Step);
    assert_eq!(debugger.controller.motion_queue().len(), 4);
    // Controller cycles without a debugger.
    for _ in 0..100 {
        debugger.controller.step();
        assert_eq!(debugger.controller.arm().joint(), READY);
    }
    assert!(debugger.controller.arm().motion().waits_for_release());
}

/// A task that can continue only after the arm has moved releases it.
#[test]
fn a_step_over_a_wait_for_the_arm_releases_it() {
    for wait in ["waitEndMove()", "wait(isEmpty())", "wait(getMoveId()>=3.5)"] {
        let listing = MANUAL.replace("  ? \"end\"", &format!("  {wait}\n  ? \"end\"")).replacen(
            "  waitEndMove()\n",
            "  ? 1\n",
            1,
        );
        let listing = if wait == "waitEndMove()" {
            listing
        } else {
            listing
                .replace("mdesc mDesc\n", "mdesc mDesc\nmdesc mStop\n")
                .replace("  movej(jD,flange,mDesc)", "  mStop.blend=off\n  movej(jD,flange,mStop)")
        };
        let mut debugger = debugger(&listing, MotionMode::Continuous);
        stop_at(&mut debugger, 10);
        run(&mut debugger).unwrap();
        debugger.set_motion_mode(MotionMode::Step);
        let step = |debugger: &mut Debugger, _: &Stop| debugger.step(task(debugger), StepKind::Over);
        step(&mut debugger, &Stop::Beginning);
        let mut lines = Vec::new();
        while let Some(stop) = run(&mut debugger) {
            assert!(matches!(stop, Stop::Step { .. }), "{wait}: {stop:?}");
            lines.push(debugger.controller.arm().motion().has_arrived());
            step(&mut debugger, &stop);
        }
        assert!(lines.iter().all(|arrived| *arrived) && !lines.is_empty(), "{wait}: {lines:?}");
        let end = debugger.controller.arm().joint();
        assert!((end[0] + 30.0).abs() < 1e-9, "{wait}: {end:?}");
    }
}

#[test]
fn an_arm_that_cannot_move_ends_the_step() {
    assert_eq!(hold_after(|controller| controller.devices.state.robot.set_power(false)), Some(ArmHold::NoPower));
    assert_eq!(hold_after(|controller| controller.devices.state.robot.press_emergency_stop()), Some(ArmHold::NoPower));
    assert_eq!(hold_after(|controller| controller.devices.state.robot.turn_speed(0.0)), Some(ArmHold::NoSpeed));
    assert_eq!(hold_after(|controller| controller.arm_mut().stop()), Some(ArmHold::Stopped));
}

/// Reason why the arm does not move in a step after a change of the controller.
fn hold_after(prepare: fn(&mut Controller)) -> Option<ArmHold> {
    let mut debugger = debugger(MANUAL, MotionMode::Step);
    stop_at(&mut debugger, 5);
    run(&mut debugger).unwrap();
    prepare(&mut debugger.controller);
    debugger.step(task(&debugger), StepKind::Over);
    let stop = run(&mut debugger).unwrap();
    let Stop::Motion(stop) = stop else { panic!("{stop:?}") };
    assert_eq!(debugger.controller.arm().joint(), READY);
    stop.hold
}

#[test]
fn a_step_of_the_motion_says_why_the_arm_does_not_move() {
    let mut debugger = debugger(MANUAL, MotionMode::Step);
    debugger.step_motion();
    let stop = run(&mut debugger);
    assert_eq!(shown(&debugger, stop.as_ref()), "start:1 [0.000, 0.000, 90.000, 0.000, 90.000, 0.000] no piece");
}

/// The order of printed lines and positions is the same as in the continuous run, with two tasks that move the arm.
#[test]
fn two_tasks_move_the_arm_in_the_same_order() {
    let listing = "\
num nTurn
program start()
mdesc mDesc
begin
  taskCreate \"other\",10,other()
  movej({20,0,90,0,90,0},flange,mDesc)
  nTurn=1
  wait(nTurn==2)
  movej({0,20,90,0,90,0},flange,mDesc)
  waitEndMove()
  ? herej()
end
program other()
mdesc mDesc
begin
  wait(nTurn==1)
  movej({0,0,70,0,90,0},flange,mDesc)
  ? \"other\"
  nTurn=2
end
";
    stops(
        &mut debugger(listing, MotionMode::Step),
        |_, _| (),
        expect![[r#"
        start:3 [13.999, 0.000, 90.000, 0.000, 90.000, 0.000] Nominal of movej start:2 to Leave
        start:4 [4.397, 0.000, 74.397, 0.000, 90.000, 0.000] Nominal of movej other:2 to Leave
        start:6 [0.000, 16.782, 86.782, 0.000, 90.000, 0.000] Nominal of movej start:5 to Leave
        start:6 [0.000, 20.000, 90.000, 0.000, 90.000, 0.000] Nominal of movej start:5 to Target
        end [0.000, 20.000, 90.000, 0.000, 90.000, 0.000]
    "#]],
    );
}

#[test]
fn the_queue_lists_each_move() {
    let mut debugger = debugger(MANUAL, MotionMode::Continuous);
    stop_at(&mut debugger, 8);
    run(&mut debugger).unwrap();
    debugger.set_motion_mode(MotionMode::Step);
    debugger.step_motion();
    run(&mut debugger).unwrap();
    let queue = debugger.controller.motion_queue();
    let first = first_row(&debugger, "start");
    for (number, queued) in queue.iter().enumerate() {
        let source = queued.source.as_ref().unwrap();
        assert_eq!(
            (source.instruction, source.program.as_str(), source.line),
            ("movej", "start", first + 4 + number as u32)
        );
        assert_eq!((queued.serial, queued.id), (number as u64, number as f64));
        assert_eq!(queued.stage, if number == 0 { MoveStage::Started } else { MoveStage::Recorded });
        assert!(queued.descriptor.is_some_and(|mdesc| mdesc.vel == 100.0 && mdesc.leave == 50.0));
        let leave = queued.leave.unwrap();
        let target = queued.target.translation.vector;
        let distance = |end: &BlendPoint| (end.pose.translation.vector - target).norm();
        assert!((distance(&leave) - leave.distance.0).abs() < 1e-6 && (leave.distance.0 - 50.0).abs() < 1e-6);
        assert_eq!(queued.reach.is_some(), number < 2);
        let requested =
            queued.blend.leave.as_ref().map(|end| (end.requested, end.effective.round(), end.cut.is_none()));
        assert_eq!((requested, queued.blend.note()), (Some((50.0, 50.0, true)), None));
        if let Some(reach) = queued.reach {
            assert!((distance(&reach) - 50.0).abs() < 1e-6 && reach.joints != leave.joints);
        }
    }
    assert_eq!(queue.len(), 3);
    assert_eq!(queue[0].leave.map(|leave| leave.joints), Some(debugger.controller.arm().joint()));
}

/// Going back passes motions; the arm and the program are at their earlier positions.
#[test]
fn steps_back_pass_the_motions_of_the_steps_forward() {
    let mut debugger = debugger(MANUAL, MotionMode::Continuous);
    debugger.record(PastLimits::snapshots(100));
    debugger.set_motion_mode(MotionMode::Step);
    stop_at(&mut debugger, 1);
    let mut forward = Vec::new();
    while let Some(stop) = run(&mut debugger)
        && forward.len() < 8
    {
        forward.push(shown(&debugger, Some(&stop)));
        debugger.step(task(&debugger), StepKind::Over);
    }
    debugger.abandon_step();
    let task = task(&debugger);
    let mut back = Vec::new();
    while let stop @ Stop::Step { .. } = debugger.step_back(task, StepKind::Over) {
        back.push(shown(&debugger, Some(&stop)));
    }
    back.reverse();
    assert_eq!(back, forward[1..]);
    // The continued run repeats the same motion.
    run(&mut debugger).unwrap();
    for expected in &forward[1..] {
        debugger.step(task, StepKind::Over);
        let stop = run(&mut debugger);
        assert_eq!(&shown(&debugger, stop.as_ref()), expected);
    }
}

#[test]
fn the_continuous_mode_goes_on_where_the_step_mode_waits() {
    let mut debugger = debugger(MANUAL, MotionMode::Step);
    run(&mut debugger).unwrap();
    debugger.set_motion_mode(MotionMode::Continuous);
    assert!(run(&mut debugger).is_none());
    let joint = debugger.controller.arm().joint();
    assert_eq!(joint, [-30.0, 10.0, 80.0, 0.0, 90.0, 0.0]);
}

/// If the arm is held within a motion, the run stops. Afterwards the arm continues to where it was released.
#[test]
fn an_arm_that_is_held_in_the_middle_of_a_motion_stops_the_run() {
    type Change = fn(&mut val3_machine::controller_state::Robot);
    let holds: [(Change, Change, ArmHold); 3] = [
        (|robot| robot.set_power(false), |robot| robot.set_power(true), ArmHold::NoPower),
        (|robot| robot.turn_speed(0.0), |robot| robot.turn_speed(100.0), ArmHold::NoSpeed),
        (|robot| robot.let_move(false), |robot| robot.let_move(true), ArmHold::Held),
    ];
    for (hold, free, expected) in holds {
        let mut debugger = debugger(MANUAL, MotionMode::Step);
        while debugger.travel_time() < 20 {
            assert!(!matches!(debugger.advance(), AdvanceResult::Stopped(_)));
        }
        hold(&mut debugger.controller.devices.state.robot);
        let Some(Stop::Motion(stop)) = run(&mut debugger) else { panic!("no stop: {expected:?}") };
        assert_eq!(stop.hold, Some(expected));
        let held = debugger.controller.arm().joint();
        assert!(held != READY && held[0] < 24.0, "{held:?}");
        free(&mut debugger.controller.devices.state.robot);
        debugger.step_motion();
        let stop = run(&mut debugger);
        assert_eq!(
            shown(&debugger, stop.as_ref()),
            "start:6 [24.792, 8.264, 81.736, 0.000, 90.000, 0.000] Nominal of movej start:5 to Leave"
        );
    }
}

trait TravelTime {
    /// Returns the number of cycles since the arm left its first position.
    fn travel_time(&self) -> u64;
}

impl TravelTime for Debugger {
    fn travel_time(&self) -> u64 {
        if self.controller.arm().joint() == READY { 0 } else { self.controller.now() / 4_000_000 }
    }
}

/// A line that changes the queue without a motion is no stop.
#[test]
fn a_line_that_moves_nothing_does_not_stop_the_run() {
    let listing = "program start()\nmdesc mDesc\njoint jHere\nbegin\n  jHere={0,0,90,0,90,0}\n  movej(jHere,flange,mDesc)\n  \
                   ? \"over\"\nend\n";
    let mut debugger = debugger(listing, MotionMode::Step);
    assert_eq!(run(&mut debugger), None);
}
