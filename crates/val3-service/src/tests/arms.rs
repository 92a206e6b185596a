//! The arm, its position and its limits.

use expect_test::expect;
use val3_soap::v0::{
    CartesianPosition, FindServer, GetControllerParameters, GetCs8Compatibility, GetCs8Versions, GetRobotJntCartPos,
    GetRobotJointPos, GetRobots, GetSoapServerVersion, SetRobotJointPos,
};
use val3_soap::v1::GetJointRange;
use val3_soap::{ExceptionCode, SoapAnswer, SoapRequest};

use super::client::Client;

fn joints(client: &mut Client) -> Vec<f64> {
    match client.ask(SoapRequest::GetRobotJointPos(GetRobotJointPos { robot: 0 })) {
        SoapAnswer::GetRobotJointPos(answer) => answer.position,
        other => panic!("{other:?}"),
    }
}

fn position(client: &mut Client, tool: Option<CartesianPosition>, frame: Option<CartesianPosition>) -> [f64; 6] {
    match client.ask(SoapRequest::GetRobotJntCartPos(GetRobotJntCartPos { robot: 0, tool, frame })) {
        SoapAnswer::GetRobotJntCartPos(answer) => {
            let CartesianPosition { x, y, z, rx, ry, rz } = answer.position;
            [x, y, z, rx, ry, rz]
        }
        other => panic!("{other:?}"),
    }
}

fn set(client: &mut Client, position: &[f64]) -> Result<(), ExceptionCode> {
    let request = SetRobotJointPos { robot: 0, position: position.to_vec() };
    let answer = client.send(SoapRequest::SetRobotJointPos(request));
    answer.result.map(drop).map_err(|fault| fault.exception.unwrap().code)
}

#[test]
fn joints_are_radians_and_lengths_metres() {
    let mut client = Client::logged_in();
    set(&mut client, &[0.1, 0.2, 1.2, 0.0, 0.5, -0.3]).unwrap();
    client.run(1);
    let expected = client.controller().arm().sample().joints.map(f64::to_radians);
    let read = joints(&mut client);
    assert_eq!(read, expected);
    assert!(read.iter().zip([0.1, 0.2, 1.2, 0.0, 0.5, -0.3]).all(|(read, set)| (read - set).abs() < 1e-12));
    let arm = client.controller().arm();
    let flange = arm.model().flange(&arm.sample().joints).translation.vector / 1000.0;
    let [x, y, z, ..] = position(&mut client, None, None);
    assert!([x - flange.x, y - flange.y, z - flange.z].iter().all(|difference| difference.abs() < 1e-12));
}

#[test]
fn a_position_is_that_of_the_tool_in_the_frame() {
    let mut client = Client::logged_in();
    set(&mut client, &[0.0; 6]).unwrap();
    let place = |x, z, rx| Some(CartesianPosition { x, y: 0.0, z, rx, ry: 0.0, rz: 0.0 });
    let flange = position(&mut client, None, None);
    let tool = position(&mut client, place(0.0, 0.1, 0.0), None);
    assert!((tool[2] - flange[2] - 0.1).abs() < 1e-12);
    let framed = position(&mut client, None, place(0.5, 0.0, std::f64::consts::FRAC_PI_2));
    assert!((framed[0] - flange[0] + 0.5).abs() < 1e-12);
    assert!((framed[1] - flange[2]).abs() < 1e-12);
}

#[test]
fn a_position_can_be_set_only_without_power() {
    let mut client = Client::logged_in();
    assert_eq!(set(&mut client, &[0.0; 5]), Err(ExceptionCode::InvalidNumberOfAxis));
    client.controller().devices.take_events();
    assert_eq!(set(&mut client, &[10.0, 0.0, 0.0, 0.0, 0.0, 0.0]), Err(ExceptionCode::InvalidParameters));
    assert_eq!(client.controller().devices.take_events(), [], "a rejected request is no action");
    client.controller().devices.state.robot.set_power(true);
    assert_eq!(set(&mut client, &[0.0; 6]), Err(ExceptionCode::SetPosPowerOn));
    let request = SoapRequest::GetRobotJointPos(GetRobotJointPos { robot: 1 });
    assert_eq!(client.code(request), ExceptionCode::InvalidRobotId);
}

#[test]
fn constants_are_those_of_the_cell() {
    let mut client = Client::logged_in();
    let requests = [
        SoapRequest::GetSoapServerVersion(GetSoapServerVersion { client_name: None, client_version: None }),
        SoapRequest::FindServer(FindServer { server_name: Some("/CS8ServerV1".to_owned()) }),
        SoapRequest::FindServer(FindServer { server_name: Some("/other".to_owned()) }),
        SoapRequest::GetRobots(GetRobots),
        SoapRequest::GetCs8Versions(GetCs8Versions),
        SoapRequest::GetCs8Compatibility(GetCs8Compatibility),
        SoapRequest::GetControllerParameters(GetControllerParameters),
        SoapRequest::GetJointRange(GetJointRange { robot: 0 }),
    ];
    let answers: Vec<String> = requests.into_iter().map(|request| format!("{:?}\n", client.ask(request))).collect();
    expect![[r#"
        GetSoapServerVersion(GetSoapServerVersionAnswer { server: InterfaceVersion { version: Some("1.2") } })
        FindServer(FindServerAnswer { found: true })
        FindServer(FindServerAnswer { found: false })
        GetRobots(GetRobotsAnswer { robots: [RobotDescription { kinematic: Anthropomorph6, arm: Some("tx90l-S1"), tuning: Some("R1"), mount: Floor, length_axis_3: Invalid, diameter_axis_3: Invalid }] })
        GetCs8Versions(GetCs8VersionsAnswer { versions: [SoftwareVersion { name: Some("val3"), version: Some("s7.11.3 - Jan 01 2024 - 00:00:00") }, SoftwareVersion { name: Some("system"), version: Some("s7.11.3") }] })
        GetCs8Compatibility(GetCs8CompatibilityAnswer { compatibility: Some("7") })
        GetControllerParameters(GetControllerParametersAnswer { parameters: [ControllerParameter { key: Some("serial"), name: Some("Serial number"), value: Some("F24_000001_C_01") }] })
        GetJointRange(GetJointRangeAnswer { range: JointRange { min: [-3.141592653589793, -2.2689280275926285, -2.530727415391778, -4.71238898038469, -2.007128639793479, -4.71238898038469], max: [3.141592653589793, 2.5743606466916362, 2.530727415391778, 4.71238898038469, 2.443460952792061, 4.71238898038469] } })
    "#]].assert_eq(&answers.concat());
}
