//! The palletiser example in step mode.

use std::collections::BTreeMap;

use camino::Utf8Path;
use val3_analysis::system::Disk;
use val3_debug::{AdvanceResult, Debugger, Stop};
use val3_lang::ports::SECOND;
use val3_machine::arm::MotionMode;
use val3_machine::controller::RunStatus;
use val3_machine::script::Script;
use val3_session::{Application, ControllerSettings, Pace, Tape};

/// In a cycle of the palletiser, each move is a stop, and no stop occurs while the arm does not move.
#[test]
fn the_palletiser_steps_from_move_to_move() {
    let cell = Utf8Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/palletiser"));
    let application = Application::open(&Disk, &cell.join("usr/usrapp/palletiser"), None).unwrap();
    let tape = Tape { records: false, replays: None };
    let image = application.compile().unwrap();
    let mut controller = application.controller(&ControllerSettings::default(), tape, image).unwrap();
    controller.follow(Script::parse(&std::fs::read_to_string(cell.join("boxes.toml")).unwrap()).unwrap());
    controller.start("start").unwrap();
    let mut debugger = Debugger::new(controller);
    debugger.set_motion_mode(MotionMode::Step);
    let mut arrivals: BTreeMap<String, u32> = BTreeMap::new();
    while debugger.controller.now() < 12 * SECOND {
        match debugger.advance() {
            AdvanceResult::Stopped(Stop::Motion(motion)) => {
                assert_eq!(motion.hold, None, "{motion:?}");
                // A move to the current position has no piece.
                let Some(found) = motion.piece else { continue };
                assert_eq!(found.piece.joints, debugger.controller.arm().joint());
                let source = found.source.unwrap();
                *arrivals.entry(source.program).or_default() += 1;
            }
            AdvanceResult::Ran(RunStatus::Waiting(wake)) => drop(Pace::default().wait(&mut debugger.controller, wake)),
            AdvanceResult::Ran(status) => assert!(!status.is_final(), "{status:?}"),
            AdvanceResult::Stopped(stop) => panic!("{stop:?}"),
        }
    }
    // Two boxes: the moves of `pick` and `place`, and the stops at their ends.
    assert!(arrivals["home"] >= 2 && arrivals["pick"] >= 8 && arrivals["place"] >= 8, "{arrivals:?}");
}
