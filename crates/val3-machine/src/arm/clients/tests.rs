//! Two queues, of which the arm executes one at a time.

use proptest::prelude::{Just, ProptestConfig, Strategy, prop, prop_oneof, proptest};
use val3_geometry::IsometryMatrix3;
use val3_kinematics::Arm;
use val3_lang::ports::CodePlace;
use val3_lang::values::MdescValue;
use val3_motion::{BlendKind, Manner, MovePath, Percent};

use super::super::{ArmHold, MoveError};
use super::*;

const START: Joints = [0.0, 0.0, 90.0, 0.0, 90.0, 0.0];

const REMOTE: Drive = Drive { may_move: true, is_attended: false, speed: Percent(100.0), tool_speed: None };

fn arm() -> RobotArm {
    let mut arm = RobotArm::new(Arm::by_name("TX2-90").unwrap());
    arm.put(START);
    arm
}

fn turned(angle: f64) -> Joints {
    let [_, j2, j3, j4, j5, j6] = START;
    [angle, j2, j3, j4, j5, j6]
}

fn to(angle: f64) -> MoveRequest {
    let descriptor = MdescValue {
        accel: 100.0,
        vel: 100.0,
        decel: 100.0,
        tvel: 99_999.0,
        rvel: 99_999.0,
        blend: BlendKind::Off,
        leave: 0.0,
        reach: 0.0,
    };
    let (path, tool) = (MovePath::Joint(turned(angle)), IsometryMatrix3::identity());
    MoveRequest { instruction: "test", path, tool, descriptor, manner: Manner::Rigid }
}

fn record(arm: &mut RobotArm, angle: f64) -> Result<Option<f64>, MoveError> {
    arm.record(&to(angle), CodePlace::default())
}

fn run(arm: &mut RobotArm) {
    (0..1000).for_each(|_| arm.advance(REMOTE));
}

#[test]
fn a_move_of_a_program_waits_for_those_of_clients() {
    let mut arm = arm();
    assert_eq!(arm.record_client_move(&to(10.0)), Ok(1));
    assert_eq!(record(&mut arm, 20.0), Ok(None));
    assert!(arm.is_done_for_programs() && !arm.is_empty());
    assert_eq!(arm.arrive(CodePlace::default()), Ok(true));
    run(&mut arm);
    assert_eq!(arm.joint(), turned(10.0));
    assert_eq!(record(&mut arm, 20.0), Ok(Some(0.0)));
    assert_eq!(arm.check_client_queue(), Err(ClientMoveError::OwnedByPrograms));
    run(&mut arm);
    assert_eq!((arm.joint(), arm.check_client_queue()), (turned(20.0), Ok(())));
}

#[test]
fn instructions_of_programs_do_not_change_moves_of_clients() {
    let mut arm = arm();
    record(&mut arm, 5.0).unwrap();
    run(&mut arm);
    arm.stop();
    arm.record_client_move(&to(10.0)).unwrap();
    assert_eq!((arm.is_stopped(), arm.move_id()), (true, 1.0));
    arm.restart();
    arm.reset(None);
    arm.stop();
    assert_eq!((arm.is_stopped(), arm.move_id()), (true, 0.0));
    run(&mut arm);
    assert_eq!((arm.joint(), arm.move_id()), (turned(10.0), 0.0));
    assert_eq!(record(&mut arm, 20.0), Ok(Some(0.0)));
    run(&mut arm);
    assert_eq!((arm.joint(), arm.hold(REMOTE)), (turned(10.0), Some(ArmHold::Stopped)));
}

#[test]
fn the_start_of_the_next_move_of_a_program_is_kept() {
    let mut arm = arm();
    arm.record_client_move(&to(10.0)).unwrap();
    arm.reset(Some(turned(3.0)));
    run(&mut arm);
    assert_eq!(arm.joint(), turned(10.0));
    assert!(arm.motion().connection().is_some());
    assert_eq!(arm.next_start(), turned(3.0));
    assert_eq!(arm.check_client_queue(), Err(ClientMoveError::OwnedByPrograms));
    assert_eq!(arm.command_by_client(ClientCommand::Reset, true), Err(ClientMoveError::OwnedByPrograms));
    assert_eq!(arm.command_by_client(ClientCommand::Reset, false), Ok(true));
    assert_eq!((arm.check_client_queue(), arm.next_start()), (Ok(()), turned(10.0)));
}

#[test]
fn an_impossible_move_of_a_client_changes_nothing() {
    let mut arm = arm();
    arm.stop();
    assert!(matches!(arm.record_client_move(&to(1000.0)), Err(ClientMoveError::Impossible(_))));
    assert!(!arm.has_client_moves() && arm.is_stopped());
    assert_eq!(record(&mut arm, 20.0), Ok(Some(0.0)));
}

#[test]
fn placing_the_arm_ends_the_moves_of_clients() {
    let mut arm = arm();
    arm.record_client_move(&to(10.0)).unwrap();
    arm.command_by_client(ClientCommand::Stop, true).unwrap();
    assert_eq!(arm.hold(REMOTE), Some(ArmHold::StoppedByClient));
    arm.put(turned(4.0));
    assert!(!arm.has_client_moves() && !arm.is_stopped());
    assert_eq!(record(&mut arm, 20.0), Ok(Some(0.0)));
}

/// Step of a client, of a program, or of the time.
#[derive(Debug, Clone)]
enum Step {
    Client(f64),
    Command(ClientCommand),
    Program(f64),
    StopMove,
    RestartMove,
    ResetMotion,
    Cycles(u16),
}

fn step() -> impl Strategy<Value = Step> {
    use ClientCommand::{Reset, Restart, Stop};
    prop_oneof![
        (-90.0..90.0).prop_map(Step::Client),
        prop_oneof![Just(Reset), Just(Stop), Just(Restart)].prop_map(Step::Command),
        (-90.0..90.0).prop_map(Step::Program),
        Just(Step::StopMove),
        Just(Step::RestartMove),
        Just(Step::ResetMotion),
        (1..300_u16).prop_map(Step::Cycles),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

    /// In any order of steps, all pending moves belong to one queue, the arm never jumps, and it finally executes the
    /// next move of a program.
    #[test]
    fn the_arm_executes_one_queue_at_a_time(steps in prop::collection::vec(step(), 1..30)) {
        let mut arm = arm();
        for step in steps {
            match step {
                Step::Client(angle) => {
                    if arm.check_client_queue().is_ok() {
                        arm.record_client_move(&to(angle)).unwrap();
                    }
                }
                Step::Command(command) => drop(arm.command_by_client(command, true)),
                Step::Program(angle) => drop(record(&mut arm, angle).unwrap()),
                Step::StopMove => arm.stop(),
                Step::RestartMove => arm.restart(),
                Step::ResetMotion => arm.reset(None),
                Step::Cycles(cycles) => {
                    for _ in 0..cycles {
                        let before = arm.joint()[0];
                        arm.advance(REMOTE);
                        assert!((arm.joint()[0] - before).abs() < 2.0, "the arm jumps");
                    }
                }
            }
            let of_clients = arm.moves().filter(|(_, origin)| origin.is_some_and(|origin| origin.at.is_none())).count();
            assert!(of_clients == 0 || of_clients == arm.moves().count() && arm.has_client_moves());
        }
        drop(arm.command_by_client(ClientCommand::Reset, true));
        arm.reset(None);
        run(&mut arm);
        assert!(record(&mut arm, 12.0).unwrap().is_some());
        run(&mut arm);
        assert_eq!(arm.joint(), turned(12.0));
    }
}
