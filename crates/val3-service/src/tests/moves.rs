//! Moves of clients.

use proptest::prelude::{Just, ProptestConfig, Strategy, any, prop, prop_oneof, proptest};
use val3_geometry::IsometryMatrix3;
use val3_machine::controller_state::WorkingMode;
use val3_machine::event::EventKind;
use val3_session::ProfileRights;
use val3_soap::v3::{
    AnthroConfig, ArmConfig, BlendType, ForwardKin, Matrix, MotionDescription, MotionResult, MoveC, MoveJc, MoveJj,
    MoveL, MoveType, PositiveNegative, ResetMotion, RestartMotion, ScaraConfig, SchedulerRefresh, Shoulder, StopMotion,
};
use val3_soap::{ExceptionCode, SoapAnswer, SoapRequest};

use super::client::{Client, profile};

const READY: [f64; 6] = [0.1, 0.2, 1.2, 0.0, 0.5, -0.3];

const SAME: ArmConfig = ArmConfig::Anthro(AnthroConfig {
    shoulder: Shoulder::Same,
    elbow: PositiveNegative::Same,
    wrist: PositiveNegative::Same,
});

const IDENTITY: Matrix = Matrix {
    nx: 1.0,
    ny: 0.0,
    nz: 0.0,
    ox: 0.0,
    oy: 1.0,
    oz: 0.0,
    ax: 0.0,
    ay: 0.0,
    az: 1.0,
    px: 0.0,
    py: 0.0,
    pz: 0.0,
};

/// Description with the values that clients send.
fn description() -> MotionDescription {
    MotionDescription {
        tool: IDENTITY,
        frame: IDENTITY,
        kind: MoveType::Absolute,
        config: SAME,
        blend: BlendType::Off,
        leave: 0.05,
        reach: 0.05,
        speed: 1.0,
        acceleration: 1.0,
        deceleration: 1.0,
        translation_speed: 99_999.0,
        rotation_speed: 99_999.0,
        frequency: 1.0,
    }
}

fn to_joints(joints: [f64; 6], description: MotionDescription) -> SoapRequest {
    SoapRequest::MoveJj(MoveJj { robot: 0, joints: joints.to_vec(), description })
}

fn line(frame: &Matrix, description: MotionDescription) -> SoapRequest {
    SoapRequest::MoveL(MoveL { robot: 0, frame: frame.clone(), description })
}

/// Client whose controller has power, and an application without tasks.
fn alone() -> Client {
    let mut client = Client::logged_in();
    client.controller().kill_tasks();
    client.controller().devices.state.robot.set_power(true);
    client
}

/// Move id and result; id 0 for a motion request without a move.
#[track_caller]
fn result(client: &mut Client, request: SoapRequest) -> (i32, MotionResult) {
    match client.ask(request) {
        SoapAnswer::MoveJj(answer)
        | SoapAnswer::MoveJc(answer)
        | SoapAnswer::MoveL(answer)
        | SoapAnswer::MoveC(answer) => (answer.id, answer.result),
        SoapAnswer::ResetMotion(answer) | SoapAnswer::StopMotion(answer) | SoapAnswer::RestartMotion(answer) => {
            (0, answer.result)
        }
        other => panic!("{other:?}"),
    }
}

/// Executes a request for a motion that succeeds. Returns the id of a move.
#[track_caller]
fn done(client: &mut Client, request: SoapRequest) -> i32 {
    let (id, result) = result(client, request);
    assert_eq!(result, MotionResult::NoError);
    id
}

/// Whether all moves are done and the arm has settled, and its joints.
fn state(client: &mut Client) -> (bool, Vec<f64>) {
    match client.ask(SoapRequest::SchedulerRefresh(SchedulerRefresh)) {
        SoapAnswer::SchedulerRefresh(mut answer) => {
            let robot = answer.robots.remove(0);
            (answer.is_empty && robot.settled, robot.joints)
        }
        other => panic!("{other:?}"),
    }
}

#[track_caller]
fn arrive(client: &mut Client, joints: [f64; 6]) {
    client.run(5);
    let (is_done, found) = state(client);
    assert!(is_done);
    assert!(found.iter().zip(joints).all(|(found, joint)| (found - joint).abs() < 1e-6), "{found:?} {joints:?}");
}

fn flange(client: &mut Client, joints: [f64; 6]) -> Matrix {
    match client.ask(SoapRequest::ForwardKin(ForwardKin { robot: 0, joints: joints.to_vec() })) {
        SoapAnswer::ForwardKin(answer) => answer.position,
        other => panic!("{other:?}"),
    }
}

/// Phases and names of the moves since the last call.
fn phases(client: &mut Client) -> Vec<String> {
    let events = client.controller().devices.take_events().into_iter();
    let moves = events.filter_map(|event| match event.kind {
        EventKind::Move { id, phase, instruction, .. } => Some(format!("{} {phase} {instruction}", id.floor())),
        _ => None,
    });
    moves.collect()
}

#[test]
fn the_arm_arrives_at_the_destination_of_each_kind_of_move() {
    let mut client = alone();
    assert_eq!(done(&mut client, to_joints(READY, description())), 1);
    assert!(!state(&mut client).0);
    arrive(&mut client, READY);
    let [near, middle, end] = [[0.2, 0.3, 1.1], [0.3, 0.2, 1.2], [0.4, 0.3, 1.1]].map(|[j1, j2, j3]| {
        let [.., j4, j5, j6] = READY;
        [j1, j2, j3, j4, j5, j6]
    });
    let [at_near, at_middle, at_end] = [near, middle, end].map(|joints| flange(&mut client, joints));
    assert_eq!(done(&mut client, line(&at_near, description())), 2);
    arrive(&mut client, near);
    let circle = MoveC { robot: 0, intermediate: at_middle, destination: at_end, description: description() };
    assert_eq!(done(&mut client, SoapRequest::MoveC(circle)), 3);
    arrive(&mut client, end);
    let point = MoveJc { robot: 0, frame: at_near, description: description() };
    assert_eq!(done(&mut client, SoapRequest::MoveJc(point)), 4);
    arrive(&mut client, near);
    let relative = MotionDescription { kind: MoveType::Relative, ..description() };
    assert_eq!(done(&mut client, to_joints([0.1, 0.0, 0.0, 0.0, 0.0, 0.2], relative)), 5);
    let [j1, j2, j3, j4, j5, j6] = near;
    arrive(&mut client, [j1 + 0.1, j2, j3, j4, j5, j6 + 0.2]);
}

#[test]
fn a_destination_is_that_of_the_tool_in_the_frame() {
    let mut client = alone();
    done(&mut client, to_joints(READY, description()));
    client.run(5);
    let at_ready = flange(&mut client, READY);
    let (tool, frame) = (Matrix { pz: 0.1, ..IDENTITY }, Matrix { px: 0.2, ..IDENTITY });
    // 0.05 m along the axis of the tool.
    let Matrix { ax, ay, az, px, py, pz, .. } = at_ready;
    let target = Matrix { px: px + 0.15 * ax - 0.2, py: py + 0.15 * ay, pz: pz + 0.15 * az, ..at_ready };
    done(&mut client, line(&target, MotionDescription { tool, frame, ..description() }));
    client.run(5);
    let sample = client.controller().arm().sample().joints;
    let moved = client.controller().arm().model().flange(&sample).translation.vector / 1000.0;
    let expected = [px + 0.05 * ax, py + 0.05 * ay, pz + 0.05 * az];
    assert!(
        moved.iter().zip(expected).all(|(moved, expected)| (moved - expected).abs() < 1e-9),
        "{moved} {expected:?}"
    );
}

/// The oracle multiplies the pose at the end of the previous move by the relative pose.
#[test]
fn relative_positions_are_along_the_axes_of_the_tool() {
    let mut client = alone();
    done(&mut client, to_joints(READY, description()));
    let tool = Matrix { nx: 0.0, ny: 1.0, ox: -1.0, oy: 0.0, px: 0.01, pz: 0.1, ..IDENTITY };
    let frame = Matrix { px: 0.3, ay: 0.6, az: 0.8, oy: 0.8, oz: -0.6, ..IDENTITY };
    let relative =
        || MotionDescription { kind: MoveType::Relative, tool: tool.clone(), frame: frame.clone(), ..description() };
    let way = Matrix { px: 0.02, py: -0.01, pz: -0.03, ay: -0.28, az: 0.96, oy: 0.96, oz: 0.28, ..IDENTITY };
    let back = Matrix { px: 0.0, py: 0.0, pz: 0.02, ..IDENTITY };
    let at_ready = isometry(&flange(&mut client, READY));
    let (to_tool, first, second) = (isometry(&tool), isometry(&way), isometry(&back));
    let on_circle = isometry(&Matrix { px: 0.02, py: 0.005, ..IDENTITY });
    let circle_end = isometry(&Matrix { px: 0.04, ..IDENTITY });
    // The second move is recorded before the first one begins.
    done(&mut client, line(&way, relative()));
    let point = MoveJc { robot: 0, frame: back, description: relative() };
    done(&mut client, SoapRequest::MoveJc(point));
    client.run(10);
    let expected = at_ready * to_tool * first * second;
    assert_flange(&mut client, expected * to_tool.inverse());
    let circle = MoveC {
        robot: 0,
        intermediate: Matrix { px: 0.02, py: 0.005, ..IDENTITY },
        destination: Matrix { px: 0.04, ..IDENTITY },
        description: relative(),
    };
    done(&mut client, SoapRequest::MoveC(circle));
    let mut nearest = f64::MAX;
    while !state(&mut client).0 {
        client.debugger.advance();
        let joints = client.controller().arm().sample().joints;
        let at = client.controller().arm().model().flange(&joints) * to_tool;
        let on_circle = (expected * on_circle).translation.vector;
        nearest = nearest.min((at.translation.vector - on_circle).norm());
    }
    assert!(nearest < 2.0, "{nearest} mm from the intermediate position");
    assert_flange(&mut client, expected * circle_end * to_tool.inverse());
}

/// Pose in mm.
fn isometry(matrix: &Matrix) -> IsometryMatrix3<f64> {
    crate::kinematics::pose(matrix).unwrap()
}

#[track_caller]
fn assert_flange(client: &mut Client, expected: IsometryMatrix3<f64>) {
    assert!(state(client).0);
    let joints = client.controller().arm().sample().joints;
    let found = client.controller().arm().model().flange(&joints);
    let difference = expected.inverse() * found;
    assert!(difference.translation.vector.norm() < 1e-6, "{expected} {found}");
    assert!(difference.rotation.angle() < 1e-8, "{expected} {found}");
}

#[test]
fn moves_blend() {
    let mut client = alone();
    let blended = MotionDescription { blend: BlendType::Joint, ..description() };
    let [_, j2, j3, j4, j5, j6] = READY;
    let joints = |j1| [j1, j2, j3, j4, j5, j6];
    done(&mut client, to_joints(READY, description()));
    client.run(5);
    phases(&mut client);
    done(&mut client, to_joints(joints(0.5), blended.clone()));
    client.run(5);
    assert!(!state(&mut client).0, "the arm waits for the next move before its blend");
    done(&mut client, to_joints([0.5, j2 + 0.4, j3, j4, j5, j6], description()));
    client.run(5);
    let expected = [
        "2 recorded moveJJ",
        "2 started moveJJ",
        "3 recorded moveJJ",
        "2 blend moveJJ",
        "2 reached moveJJ",
        "2 done moveJJ",
        "3 started moveJJ",
        "3 done moveJJ",
    ];
    assert_eq!(phases(&mut client), expected);
    assert!(state(&mut client).0);
}

#[test]
fn moves_need_power_and_the_remote_mode() {
    let mut client = alone();
    let refused = |client: &mut Client| result(client, to_joints(READY, description()));
    client.controller().devices.state.robot.set_power(false);
    assert_eq!(refused(&mut client), (0, MotionResult::NotReady));
    done(&mut client, SoapRequest::ResetMotion(ResetMotion));
    client.controller().devices.state.robot.set_mode(WorkingMode::Local, 0);
    client.controller().devices.state.robot.set_power(true);
    assert_eq!(refused(&mut client), (0, MotionResult::NotReady));
    assert_eq!(result(&mut client, SoapRequest::ResetMotion(ResetMotion)).1, MotionResult::NotReady);
    let rights = ProfileRights { read: true, write: false, write_io: true };
    let mut client = Client::with(vec![profile("reader", rights)]);
    client.login("reader", "");
    for request in [to_joints(READY, description()), SoapRequest::StopMotion(StopMotion)] {
        assert_eq!(client.code(request), ExceptionCode::WriteAccess);
    }
}

#[test]
fn another_mode_holds_the_moves() {
    let mut client = alone();
    done(&mut client, to_joints(READY, description()));
    client.controller().devices.state.robot.set_mode(WorkingMode::Local, 0);
    client.controller().devices.state.robot.set_power(true);
    client.controller().devices.state.robot.let_move(true);
    client.run(3);
    assert_ne!(state(&mut client).1, READY);
    let now = client.controller().now();
    client.controller().devices.state.robot.set_mode(WorkingMode::Remote, now);
    client.controller().devices.state.robot.set_power(true);
    arrive(&mut client, READY);
}

#[test]
fn a_rejected_move_blocks_the_moves_until_the_reset() {
    let mut client = alone();
    let at_ready = flange(&mut client, READY);
    let wrong = |change: fn(&mut MotionDescription)| {
        let mut description = description();
        change(&mut description);
        to_joints(READY, description)
    };
    let requests = [
        to_joints([10.0, 0.0, 0.0, 0.0, 0.0, 0.0], description()),
        line(&Matrix { px: 9.0, ..at_ready.clone() }, description()),
        line(&Matrix { px: 1e300, ..at_ready.clone() }, description()),
        line(&Matrix { nx: 0.0, ny: 0.0, nz: 0.0, ..at_ready.clone() }, description()),
        wrong(|description| description.tool.nx = 0.0),
        wrong(|description| description.frame.az = -1.0),
        wrong(|description| description.speed = 0.0),
        wrong(|description| description.speed = 1e308),
        wrong(|description| description.deceleration = -1.0),
        wrong(|description| description.translation_speed = 0.0),
        wrong(|description| description.reach = -0.1),
        wrong(|description| description.leave = 1e308),
    ];
    for request in requests {
        let shown = format!("{request:?}");
        assert_eq!(result(&mut client, request), (0, MotionResult::WrongParameter), "{shown}");
        assert_eq!(result(&mut client, to_joints(READY, description())), (0, MotionResult::Misuse), "{shown}");
        done(&mut client, SoapRequest::ResetMotion(ResetMotion));
    }
    let log = client.controller().devices.take_events().into_iter().filter_map(|event| match event.kind {
        EventKind::Log { text, .. } => Some(text),
        _ => None,
    });
    let log: Vec<String> = log.collect();
    assert!(log.iter().any(|text| text.contains("moveL of a client: `frame` is no right-handed frame")), "{log:#?}");
    assert!(log.iter().any(|text| text.contains("moveJJ of a client: bad vel")), "{log:#?}");
}

#[test]
fn wrong_arguments_are_faults() {
    let mut client = alone();
    let mut code = |change: fn(&mut MoveJj)| {
        let mut request = MoveJj { robot: 0, joints: READY.to_vec(), description: description() };
        change(&mut request);
        client.code(SoapRequest::MoveJj(request))
    };
    assert_eq!(code(|request| request.robot = 1), ExceptionCode::InvalidRobotId);
    assert_eq!(code(|request| request.joints.push(0.0)), ExceptionCode::InvalidNumberOfAxis);
    assert_eq!(code(|request| request.description.frequency = 0.0), ExceptionCode::InvalidMotDesc);
    let config = ArmConfig::Scara(ScaraConfig { shoulder: Shoulder::Same });
    let request = line(&IDENTITY, MotionDescription { config, ..description() });
    assert_eq!(client.code(request), ExceptionCode::InvalidConfig);
    done(&mut client, to_joints(READY, description()));
}

#[test]
fn the_motion_is_stopped_restarted_and_reset() {
    let mut client = alone();
    let slow = || MotionDescription { speed: 0.1, ..description() };
    for request in [SoapRequest::StopMotion(StopMotion), SoapRequest::RestartMotion(RestartMotion)] {
        done(&mut client, request);
    }
    done(&mut client, to_joints(READY, slow()));
    client.run(1);
    done(&mut client, SoapRequest::StopMotion(StopMotion));
    client.run(2);
    let (_, stopped) = state(&mut client);
    client.run(2);
    assert_eq!(state(&mut client), (false, stopped.clone()));
    done(&mut client, SoapRequest::RestartMotion(RestartMotion));
    client.run(1);
    assert_ne!(state(&mut client).1, stopped);
    done(&mut client, SoapRequest::ResetMotion(ResetMotion));
    client.run(2);
    let (is_done, reset) = state(&mut client);
    assert!(is_done && reset != READY, "{reset:?}");
    assert_eq!(done(&mut client, to_joints(READY, description())), 2);
    arrive(&mut client, READY);
}

/// The palletiser enters its first move in the first second, which then waits for the power.
#[test]
fn the_application_owns_the_arm_until_its_moves_are_done() {
    let mut client = Client::logged_in();
    client.run(1);
    client.controller().devices.state.robot.set_power(true);
    let requests = || {
        [
            to_joints(READY, description()),
            SoapRequest::ResetMotion(ResetMotion),
            SoapRequest::StopMotion(StopMotion),
            SoapRequest::RestartMotion(RestartMotion),
        ]
    };
    for request in requests() {
        assert_eq!(result(&mut client, request).1, MotionResult::Misuse);
    }
    assert!(!client.controller().arm().is_empty());
    client.controller().kill_tasks();
    assert_eq!(result(&mut client, to_joints(READY, description())).1, MotionResult::Misuse);
    done(&mut client, SoapRequest::ResetMotion(ResetMotion));
    done(&mut client, to_joints(READY, description()));
    arrive(&mut client, READY);
}

#[test]
fn a_move_of_the_application_waits_for_the_moves_of_clients() {
    let mut client = Client::logged_in();
    client.controller().arm_mut().put(READY.map(f64::to_degrees));
    client.controller().devices.state.robot.set_power(true);
    let slow = || MotionDescription { speed: 0.1, ..description() };
    let [j1, j2, j3, j4, j5, j6] = READY;
    done(&mut client, to_joints([j1 + 0.5, j2, j3, j4, j5, j6], slow()));
    done(&mut client, to_joints(READY, slow()));
    client.run(1);
    assert_eq!(phases(&mut client), ["1 recorded moveJJ", "2 recorded moveJJ", "1 started moveJJ"]);
    client.run(30);
    let phases = phases(&mut client);
    assert_eq!(phases[..3], ["1 done moveJJ", "2 started moveJJ", "2 done moveJJ"]);
    assert!(phases[3].starts_with("0 recorded "), "{phases:?}");
    assert!(phases[4..].iter().any(|phase| phase.starts_with("0 done ")), "{phases:?}");
}

/// Any finite number of a request.
fn number() -> impl Strategy<Value = f64> {
    prop_oneof![
        Just(0.0),
        Just(1.0),
        Just(f64::MAX),
        Just(f64::MIN_POSITIVE),
        Just(-1e-300),
        Just(1e150),
        -2.0..2.0_f64,
        any::<f64>().prop_filter("finite", |number| number.is_finite()),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn no_numbers_break_the_controller(
        numbers in prop::collection::vec(number(), 20),
        joints in prop::array::uniform6(-1.0..1.0_f64),
        kind in prop_oneof![Just(MoveType::Absolute), Just(MoveType::Relative)],
        blend in prop_oneof![Just(BlendType::Off), Just(BlendType::Joint), Just(BlendType::Cartesian)],
    ) {
        let mut client = alone();
        let Ok([
            leave, reach, speed, acceleration, deceleration, translation_speed, rotation_speed, frequency,
            tx, ty, tz, px, py, pz, j1, j2, j3, j4, j5, j6,
        ]) = <[f64; 20]>::try_from(numbers) else { panic!("20 numbers") };
        let (tool, frame) = (Matrix { px: tx, py: ty, pz: tz, ..IDENTITY }, Matrix { px, py, pz, ..IDENTITY });
        let plain = MotionDescription { tool, blend, kind, leave, reach, ..description() };
        let timed = MotionDescription {
            speed, acceleration, deceleration, translation_speed, rotation_speed, frequency, ..plain.clone()
        };
        let requests = [
            to_joints([j1, j2, j3, j4, j5, j6], plain.clone()),
            to_joints(joints, timed.clone()),
            line(&frame, plain),
            to_joints(joints, MotionDescription { frame, ..timed }),
        ];
        for request in requests {
            client.send(request);
            client.debugger.advance();
            client.send(SoapRequest::ResetMotion(ResetMotion));
        }
        let (_, joints) = state(&mut client);
        assert!(joints.iter().all(|joint| joint.is_finite()), "{joints:?}");
    }
}
