//! Teaching of frames and tools.

use val3_geometry::{IsometryMatrix3, Trsf};
use val3_kinematics::Joints;
use val3_test::Fixture;

use super::*;

const LISTING: &str = r#"
frame fBase
frame fTable
tool tChanger
tool tGripper
point pPick

program start()
begin
  link(fBase,world)
  fBase.trsf={FBASE,0,0,90}
  link(fTable,fBase)
  link(pPick,fTable)
  link(tChanger,flange)
  tChanger.trsf={TCHANGER,0,0,45}
  link(tGripper,tChanger)
  tGripper.trsf={TGRIPPER,0,90,0}
  delay(1)
end
"#;

const START: [f64; 6] = [10.0, 20.0, 80.0, 10.0, 60.0, 0.0];

/// Length units of the application, in mm.
const UNITS: [f64; 2] = [1.0, 25.4];

fn started() -> Controller {
    started_in(1.0)
}

/// Starts the same application in a length unit.
fn started_in(unit: f64) -> Controller {
    let places = [("FBASE", [100.0, 200.0, 0.0]), ("TCHANGER", [0.0, 0.0, 30.0]), ("TGRIPPER", [1.0, 2.0, 3.0])];
    let listing = places.into_iter().fold(LISTING.to_owned(), |listing, (name, place)| {
        listing.replace(name, &place.map(|length| (length / unit).to_string()).join(","))
    });
    let listing = if unit == 1.0 { listing } else { Fixture::in_inches(&listing) };
    let mut controller = Running::start(&listing).controller;
    controller.step();
    controller
}

/// Coordinates of data with lengths in a unit, from coordinates in mm.
fn data([x, y, z, rx, ry, rz]: [f64; 6], unit: f64) -> [f64; 6] {
    [x / unit, y / unit, z / unit, rx, ry, rz]
}

fn execute(
    operator: &mut Operator,
    name: &str,
    arguments: &Value,
    controller: &mut Controller,
) -> Result<Value, String> {
    let done = operator.execute(name, arguments.as_object().unwrap(), controller);
    done.map(|keys| json!(keys)).map_err(|error| error.to_string())
}

fn shown(name: &str, base: BaseType, controller: &Controller) -> Value {
    let data = positions::data(controller);
    let values = PositionComputer::new(&data, controller).of_type(base);
    json!(values.into_iter().find(|value| value.name == name).unwrap())
}

fn is_near(value: &Value, expected: [f64; 6]) -> bool {
    value.as_array().unwrap().iter().zip(expected).all(|(is, expected)| (is.as_f64().unwrap() - expected).abs() < 1e-6)
}

/// Joints at which the flange has this pose.
fn joints_at(flange: IsometryMatrix3<f64>, controller: &Controller) -> Vec<f64> {
    let model = controller.arm().model();
    let solved = model.branches().iter().find_map(|branch| model.inverse_isometry_on(*branch, &flange, &START).ok());
    solved.expect("the pose is in reach").to_vec()
}

fn flange_of(controller: &Controller, joints: &Joints) -> IsometryMatrix3<f64> {
    controller.arm().model().flange(joints)
}

#[test]
fn a_frame_is_taught_by_three_positions_and_undone() {
    for unit in UNITS {
        let mut controller = started_in(unit);
        let tool = Trsf::new([0.0, 0.0, 30.0], [0.0, 0.0, 45.0]).isometry();
        let start = flange_of(&controller, &START);
        let at = |x: f64, y: f64, controller: &Controller| {
            let mut centre = start * tool;
            centre.translation.vector = val3_geometry::Vector3::new(x, y, 500.0);
            joints_at(centre * tool.inverse(), controller)
        };
        let joints = [at(400.0, 100.0, &controller), at(400.0, 200.0, &controller), at(300.0, 150.0, &controller)];
        let arguments = json!({ "name": "fTable", "tool": { "name": "tChanger" }, "joints": joints });
        let mut operator = Operator::default();
        execute(&mut operator, "teachFrame", &arguments, &mut controller).unwrap();
        let frame = shown("fTable", BaseType::Frame, &controller);
        assert!(is_near(&frame["pose"], [400.0, 100.0, 500.0, 0.0, 0.0, 90.0]), "{frame}");
        assert!(is_near(&frame["local"], data([-100.0, -300.0, 500.0, 0.0, 0.0, 0.0], unit)), "{frame}");
        assert_eq!(json!(operator.unsaved())["undo"]["name"], "fTable");
        execute(&mut operator, "undo", &json!({}), &mut controller).unwrap();
        assert!(is_near(&shown("fTable", BaseType::Frame, &controller)["local"], [0.0; 6]));
        assert_eq!(json!(operator.unsaved())["points"], json!([]));
    }
}

#[test]
fn positions_of_a_frame_are_ten_millimetres_apart() {
    let mut controller = started();
    let start = flange_of(&controller, &START);
    let at = |x: f64, y: f64| {
        let mut flange = start;
        flange.translation.vector += val3_geometry::Vector3::new(x, y, 0.0);
        joints_at(flange, &controller)
    };
    let [origin, near, far, beside] = [at(0.0, 0.0), at(9.9, 0.0), at(50.0, 0.0), at(20.0, 9.9)];
    let mut refused = |joints: Value| {
        let arguments = json!({ "name": "fTable", "tool": { "name": "flange" }, "joints": joints });
        execute(&mut Operator::default(), "teachFrame", &arguments, &mut controller).unwrap_err()
    };
    let x = refused(json!([origin, near, beside]));
    assert_eq!(x, "the point on the x axis is too close to the origin; at least 10 mm are necessary");
    assert!(refused(json!([origin, far, beside])).contains("too close to the x axis"));
    assert!(refused(json!([origin, far])).contains("three joint positions"));
    assert!(refused(json!([[1, 2], far, beside])).contains("has 6 numbers"));
    assert!(refused(json!([[999, 0, 0, 0, 0, 0], far, beside])).contains("axis 1"));
}

#[test]
fn a_tool_is_taught_by_four_positions_with_its_residual() {
    for unit in UNITS {
        let mut controller = started_in(unit);
        let tip = val3_geometry::Vector3::new(20.0, -15.0, 140.0);
        let start = flange_of(&controller, &START);
        let place = start.rotation * tip + start.translation.vector;
        let touching = |angles: [f64; 3], error: f64, controller: &Controller| {
            let mut flange = start * Trsf::new([0.0; 3], angles).isometry();
            flange.translation.vector = place - flange.rotation * tip;
            flange.translation.vector.x += error;
            joints_at(flange, controller)
        };
        let angles = [[0.0; 3], [20.0, 0.0, 0.0], [0.0, 20.0, 0.0], [-20.0, 0.0, 10.0]];
        let mut operator = Operator::default();
        for error in [0.0, 0.5] {
            let errors = [error, 0.0, 0.0, 0.0];
            let positions = angles.iter().zip(errors);
            let joints: Vec<_> = positions.map(|(angles, error)| touching(*angles, error, &controller)).collect();
            let arguments = json!({ "name": "tGripper", "joints": joints });
            let taught = execute(&mut operator, "teachTool", &arguments, &mut controller).unwrap();
            let residual = taught["residual"].as_f64().unwrap();
            assert_eq!((residual > 1e-6, residual < 0.5), (error > 0.0, true), "{residual}");
            let tool = shown("tGripper", BaseType::Tool, &controller);
            let pose: Vec<f64> =
                tool["pose"].as_array().unwrap().iter().map(|number| number.as_f64().unwrap()).collect();
            let apart = (val3_geometry::Vector3::new(pose[0], pose[1], pose[2]) - tip).norm();
            assert!(apart < 1e-6 + 10.0 * error, "{apart}");
            assert!(is_near(&json!(tool["local"].as_array().unwrap()[3..]), [0.0, 90.0, 0.0, 0.0, 0.0, 0.0]), "{tool}");
        }
        let same = vec![START.to_vec(); 4];
        let refused =
            execute(&mut operator, "teachTool", &json!({ "name": "tGripper", "joints": same }), &mut controller);
        assert_eq!(refused.unwrap_err(), "the orientations of positions 1 and 2 are less than 5 degrees apart");
        assert_eq!(json!(operator.unsaved())["points"], json!([{ "name": "tGripper", "key": null }]));
    }
}
