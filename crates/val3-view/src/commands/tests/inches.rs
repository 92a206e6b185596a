//! Data of applications in inches.

use val3_kinematics::Arm;
use val3_machine::arm::RobotArm;
use val3_test::Fixture;

use super::*;
use crate::wire;

/// The listing of the neighbouring tests, with a tool and a joint position of a SCARA arm.
fn controller() -> Controller {
    let listing = LISTING.replace("frame fTable", "jointRs jLow\ntool tLong\nframe fTable");
    let lines = "begin\n  link(tLong,flange)\n  tLong.trsf.z=2\n  jLow={10,20,1.5,40}";
    let mut controller = Running::start(&Fixture::in_inches(&listing.replace("begin", lines))).controller;
    controller.step();
    controller
}

fn lengths(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().take(3).map(|number| number.as_f64().unwrap()).collect()
}

fn is_near(numbers: &[f64], expected: &[f64]) -> bool {
    numbers.iter().zip(expected).all(|(is, expected)| (is - expected).abs() < 1e-9)
}

#[test]
fn values_are_in_inches_and_poses_in_mm() {
    let mut controller = controller();
    assert_eq!(json!(crate::scene(&controller, wire::Role::Guest))["lengthUnit"], "inch");
    run(&mut controller, "setPoint", json!({ "name": "pPick", "key": 1, "local": [0, 10, 2, 0, 0, 0] })).unwrap();
    let point = shown_point(&controller);
    assert_eq!(lengths(&point["local"]), [0.0, 10.0, 2.0]);
    let pose = lengths(&point["pose"]);
    assert!(is_near(&pose, &[490.0 * 25.4, 0.0, 302.0 * 25.4]), "{pose:?}");
    let far = json!({ "name": "pPick", "key": 1, "local": [4000, 0, 0, 0, 0, 0] });
    let refused = run(&mut controller, "setPoint", far).unwrap_err();
    assert_eq!(refused, "x is 4000, outside the range from -3937 to 3937 inches");
}

#[test]
fn tools_are_found_by_their_poses_in_mm() {
    let controller = controller();
    let tool_at = |z: f64| positions::tool_at(&controller, |pose| is_near(pose, &[0.0, 0.0, z]));
    assert_eq!((tool_at(50.8).as_deref(), tool_at(2.0)), (Some("tLong"), None));
}

#[test]
fn joints_of_a_linear_axis_are_solved_in_mm() {
    let mut controller = controller();
    controller.devices.state.arm = RobotArm::new(Arm::by_name("TS2-60").unwrap());
    let solve = json!({ "name": "jLow", "tool": { "name": "flange" } });
    let solved = Operator::default().execute("solve", solve.as_object().unwrap(), &mut controller).unwrap();
    assert_eq!(solved["solutions"][0]["joints"], json!([10.0, 20.0, 1.5 * 25.4, 40.0]));
    let values = positions::joints(&positions::data(&controller), &controller.vm.space.memory).remove(0).values;
    assert_eq!(values, [10.0, 20.0, 1.5, 40.0]);
}
