//! Run-time errors that stop the run.

use val3_debug::{Debugger, PastLimits, StepKind, Stop, StopErrors, handler};

use crate::debugger::{debugger, run, set};

/// Whether an error stops the run of a task that fails, next to a task with these lines and programs.
fn stops(lines: &str, errors: StopErrors) -> bool {
    let mut debugger = debugger(&format!(
        "program start()\nbegin\n  taskCreate \"work\",10,work()\n  {lines}\nend\nprogram work()\nnum l_nZero\nbegin\n  \
         delay(0.1)\n  ? 1/l_nZero\nend\nprogram watch()\nbegin\n  call look()\n  delay(0)\nend\nprogram look()\nbegin\n  \
         if taskStatus(\"work\")>1\n    taskKill(\"work\")\n  endIf\nend\n"
    ));
    debugger.set_errors(errors);
    let stop = run(&mut debugger);
    assert!(matches!(stop, None | Some(Stop::Error { .. })), "{stop:?}");
    stop.is_some()
}

fn unhandled() -> StopErrors {
    StopErrors { unhandled: true, ..StopErrors::default() }
}

#[test]
fn an_error_that_no_task_looks_for_is_unhandled() {
    for (lines, expected) in [
        ("delay(1)", true),
        ("? 1", true),
        ("while clock()<1\n    call watch()\n  endWhile", false),
        ("wait(taskStatus(\"work\")>1)\n  taskKill(\"work\")", false),
        ("taskCreate \"other\",10,watch()\n  delay(1)", true),
        ("call look()\n  delay(0.01)\n  while clock()<1\n    delay(0)\n  endWhile", false),
    ] {
        assert_eq!(stops(lines, unhandled()), expected, "{lines}");
        assert!(stops(lines, StopErrors::all()), "{lines}");
        assert!(!stops(lines, StopErrors::default()), "{lines}");
    }
}

#[test]
fn filters_add_up() {
    let handled = "wait(taskStatus(\"work\")>1)\n  taskKill(\"work\")";
    let motion = StopErrors { motion: true, ..StopErrors::default() };
    assert!(!stops(handled, motion.clone()));
    assert!(!stops(handled, StopErrors::only([20])));
    assert!(stops(handled, StopErrors { unhandled: true, numbers: [10].into(), ..motion }));
}

#[test]
fn errors_of_motion_descriptors_are_motion_errors() {
    let listing = "program start()\njoint l_jTarget\ntool l_tTool\nmdesc l_mFast\nbegin\n  l_mFast.vel=0\n  \
                   movej(l_jTarget,flange,l_mFast)\nend\n";
    for (motion, expected) in [(true, true), (false, false)] {
        let mut debugger = debugger(listing);
        debugger.set_errors(StopErrors { motion, ..StopErrors::only([10]) });
        let stop = run(&mut debugger);
        assert_eq!(stop.is_some(), expected, "{stop:?}");
    }
}

/// A task that no longer exists or is halted handles nothing.
#[test]
fn a_failed_task_does_not_handle_its_own_error() {
    let mut debugger =
        debugger("program start()\nnum l_nZero\nbegin\n  if taskStatus(\"none\")<0\n    ? 1/l_nZero\n  endIf\nend\n");
    debugger.set_errors(unhandled());
    let Some(Stop::Error { task, .. }) = run(&mut debugger) else { panic!("no stop") };
    assert_eq!(handler(&debugger.controller.vm, task), None);
}

/// The blend between two lines past axis 1 of a TX2-90 would move the wrist through the axis.
const CUT_CORNER: &str = "program start()\nmdesc m\npoint p\nbegin\n  p=jointToPoint(flange,world,{0,0,90,0,90,0})\n  \
                          p.trsf={80,300,p.trsf.z,180,0,180}\n  m.blend=off\n  movej(p,flange,m)\n  m.blend=Cartesian\n  \
                          m.leave=200\n  m.reach=200\n  p.trsf.y=-80\n  movel(p,flange,m)\n  p.trsf.x=-300\n  \
                          movel(p,flange,m)\n  delay(5)\nend\n";

#[test]
fn an_arm_that_stops_before_an_impossible_path_is_a_motion_error() {
    for (motion, expected) in [(true, true), (false, false)] {
        let mut debugger = debugger(CUT_CORNER);
        debugger.controller.devices.state.robot.set_power(true);
        debugger.controller.arm_mut().put([0.0, 0.0, 90.0, 0.0, 90.0, 0.0]);
        debugger.set_errors(StopErrors { motion, ..StopErrors::default() });
        let stop = run(&mut debugger);
        let Some(Stop::PathFault(fault)) = stop else {
            assert!(stop.is_none() && !expected, "{stop:?}");
            continue;
        };
        let source = fault.source.map(|source| (source.instruction, source.program));
        assert_eq!(source, Some(("movel", "start".to_owned())), "{}", fault.text);
        assert_eq!(run(&mut debugger), None, "a path stops the run once");
    }
}

/// Going back, by breakpoints and by lines, also stops before the path, and the run can continue from there.
#[test]
fn going_back_stops_before_an_impossible_path() {
    let mut debugger = debugger(&CUT_CORNER.replace("delay(5)", "delay(5)\n  delay(1)"));
    debugger.controller.devices.state.robot.set_power(true);
    debugger.controller.arm_mut().put([0.0, 0.0, 90.0, 0.0, 90.0, 0.0]);
    debugger.record(PastLimits::snapshots(100));
    debugger.set_errors(StopErrors { motion: true, ..StopErrors::default() });
    assert_eq!(set(&mut debugger, "start", &[(13, None)]), [Some(13)]);
    let Some(Stop::PathFault(fault)) = run(&mut debugger) else { panic!("no stop") };
    let place = |debugger: &Debugger| (debugger.controller.now(), debugger.controller.arm().sample().joints);
    let there = place(&debugger);
    assert_eq!(debugger.run_back(), Stop::Beginning, "the run is at the path already");
    assert_eq!(run(&mut debugger), Some(Stop::PathFault(fault.clone())));
    for kind in [None, Some(StepKind::In), Some(StepKind::Over)] {
        let Some(Stop::Breakpoints { task, .. }) = run(&mut debugger) else { panic!("no breakpoint") };
        let stop = match kind {
            None => debugger.run_back(),
            Some(kind) => debugger.step_back(task, kind),
        };
        assert_eq!((stop, place(&debugger)), (Stop::PathFault(fault.clone()), there), "{kind:?}");
    }
    debugger.set_errors(StopErrors::default());
    assert_eq!(debugger.run_back(), Stop::Beginning);
}
