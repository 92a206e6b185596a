//! Kinematics, power and the state of the moves.

use val3_machine::controller_state::WorkingMode;
use val3_soap::v0::SetRobotJointPos;
use val3_soap::v1::JointRange;
use val3_soap::v3::{
    AnthroConfig, ArmConfig, ForwardKin, Matrix, PositiveNegative, PowerResult, ReverseKin, ReversingResult,
    ScaraConfig, SchedulerRefresh, SchedulingMode, SetPower, SetSchedulingMode, Shoulder,
};
use val3_soap::{ExceptionCode, SoapAnswer, SoapRequest};

use super::client::Client;

const JOINTS: [f64; 6] = [0.1, 0.2, 1.2, 0.3, 0.5, -0.3];

const FREE: ArmConfig = ArmConfig::Anthro(AnthroConfig {
    shoulder: Shoulder::Free,
    elbow: PositiveNegative::Free,
    wrist: PositiveNegative::Free,
});

fn forward(client: &mut Client, joints: &[f64]) -> (Matrix, ArmConfig) {
    match client.ask(SoapRequest::ForwardKin(ForwardKin { robot: 0, joints: joints.to_vec() })) {
        SoapAnswer::ForwardKin(answer) => (answer.position, answer.config),
        other => panic!("{other:?}"),
    }
}

fn inverse(target: Matrix, config: ArmConfig, range: [&[f64]; 2]) -> SoapRequest {
    let [min, max] = range.map(<[f64]>::to_vec);
    let (near, range) = (JOINTS.to_vec(), JointRange { min, max });
    SoapRequest::ReverseKin(ReverseKin { robot: 0, near, target, config, range })
}

fn reverse(client: &mut Client, target: &Matrix, config: ArmConfig, range: [&[f64]; 2]) -> (Vec<f64>, ReversingResult) {
    match client.ask(inverse(target.clone(), config, range)) {
        SoapAnswer::ReverseKin(answer) => (answer.joints, answer.result),
        other => panic!("{other:?}"),
    }
}

#[test]
fn joints_and_positions_are_converted_in_both_directions() {
    let mut client = Client::logged_in();
    let (position, config) = forward(&mut client, &JOINTS);
    let ArmConfig::Anthro(AnthroConfig { wrist, .. }) = &config else { panic!("{config:?}") };
    assert_eq!(*wrist, PositiveNegative::Positive);
    for config in [config, FREE] {
        let (joints, result) = reverse(&mut client, &position, config, [&[], &[]]);
        assert_eq!(result, ReversingResult::Ok);
        assert!(joints.iter().zip(JOINTS).all(|(one, other)| (one - other).abs() < 1e-9), "{joints:?}");
    }
}

#[test]
fn a_failure_has_its_reason() {
    let mut client = Client::logged_in();
    let (position, config) = forward(&mut client, &JOINTS);
    let mut result = |target: &Matrix, config, range| reverse(&mut client, target, config, range).1;
    let far = Matrix { px: 9.0, ..position.clone() };
    assert_eq!(result(&far, FREE, [&[], &[]]), ReversingResult::OutOfWorkspace);
    let zeros = Matrix { nx: 0.0, ny: 0.0, nz: 0.0, ..position.clone() };
    assert_eq!(result(&zeros, FREE, [&[], &[]]), ReversingResult::UnconstrainedFrame);
    let left_handed = Matrix { ax: -position.ax, ay: -position.ay, az: -position.az, ..position.clone() };
    assert_eq!(result(&left_handed, FREE, [&[], &[]]), ReversingResult::UnconstrainedFrame);
    let narrow: [&[f64]; 2] = [&[0.5, -1.0, -1.0, -1.0, -1.0, -1.0], &[1.0; 6]];
    assert_eq!(result(&position, config, narrow), ReversingResult::OutOfJointRange);
    let scara = ArmConfig::Scara(ScaraConfig { shoulder: Shoulder::Free });
    assert_eq!(client.code(inverse(position.clone(), scara, [&[], &[]])), ExceptionCode::InvalidConfig);
    assert_eq!(client.code(inverse(position, FREE, [&[0.0], &[]])), ExceptionCode::InvalidNumberOfAxis);
    let few = SoapRequest::ForwardKin(ForwardKin { robot: 0, joints: vec![0.0; 5] });
    assert_eq!(client.code(few), ExceptionCode::InvalidNumberOfAxis);
}

#[test]
fn power_is_switched_in_the_remote_mode() {
    let mut client = Client::logged_in();
    let power = |client: &mut Client, power| match client.ask(SoapRequest::SetPower(SetPower { power })) {
        SoapAnswer::SetPower(answer) => answer.code,
        other => panic!("{other:?}"),
    };
    assert_eq!(power(&mut client, true), PowerResult::NoError);
    assert!(client.controller().devices.state.robot.is_powered());
    assert_eq!(power(&mut client, false), PowerResult::NoError);
    client.controller().devices.state.robot.press_emergency_stop();
    assert_eq!(power(&mut client, true), PowerResult::EnableTimeout);
    client.controller().devices.state.robot.set_mode(WorkingMode::Local, 0);
    assert_eq!(power(&mut client, true), PowerResult::OnlyInRemoteMode);
}

#[test]
fn the_state_of_the_moves_is_that_of_the_arm() {
    let mut client = Client::logged_in();
    client.ask(SoapRequest::SetRobotJointPos(SetRobotJointPos { robot: 0, position: JOINTS.to_vec() }));
    let state = |client: &mut Client| match client.ask(SoapRequest::SchedulerRefresh(SchedulerRefresh)) {
        SoapAnswer::SchedulerRefresh(mut answer) => (answer.is_empty, answer.robots.remove(0)),
        other => panic!("{other:?}"),
    };
    assert!(state(&mut client).0);
    // The application has recorded a move, which waits for the power.
    client.run(1);
    let (is_empty, robot) = state(&mut client);
    assert_eq!((is_empty, robot.settled), (false, true));
    assert!((robot.position.px - forward(&mut client, &JOINTS).0.px).abs() < 1e-9);
    let external = SoapRequest::SetSchedulingMode(SetSchedulingMode { mode: SchedulingMode::External });
    assert_eq!(client.code(external), ExceptionCode::SchedulingMode);
    client.ask(SoapRequest::SetSchedulingMode(SetSchedulingMode { mode: SchedulingMode::Internal }));
}
