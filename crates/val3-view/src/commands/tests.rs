use serde_json::{Value, json};
use val3_machine::controller::Controller;
use val3_tests::running::Running;

use super::*;
use crate::positions::PositionComputer;

const LISTING: &str = r#"
frame fTable
point pPick[2]

program start()
begin
  link(fTable,world)
  fTable.trsf={500,0,300,0,0,90}
  link(pPick[1],fTable)
  pPick[1].config.shoulder=righty
  delay(1)
end
"#;

fn controller() -> Controller {
    let mut controller = Running::start(LISTING).controller;
    controller.step();
    controller
}

fn run(controller: &mut Controller, name: &str, arguments: Value) -> Result<(), String> {
    let done = Operator::default().execute(name, arguments.as_object().unwrap(), controller);
    done.map(|_| ()).map_err(|error| error.to_string())
}

fn shown_point(controller: &Controller) -> Value {
    let points = PositionComputer::new(&positions::data(controller), controller).of_type(BaseType::Point);
    json!(points.into_iter().find(|point| point.name == "pPick" && point.key.as_deref() == Some("1")).unwrap())
}

#[test]
fn a_point_gets_other_values() {
    let mut controller = controller();
    let local = json!([0, 100, 50, 0, 0, 0]);
    run(&mut controller, "setPoint", json!({ "name": "pPick", "key": "1", "local": local })).unwrap();
    let point = shown_point(&controller);
    assert_eq!((&point["local"], &point["father"]), (&json!([0.0, 100.0, 50.0, 0.0, 0.0, 0.0]), &json!("fTable")));
    let pose: Vec<f64> = point["pose"].as_array().unwrap().iter().map(|number| number.as_f64().unwrap()).collect();
    assert!(pose.iter().zip([400.0, 0.0, 350.0, 0.0, 0.0, 90.0]).all(|(is, expected)| (is - expected).abs() < 1e-9));
}

/// The frame becomes the father of the point. Undoing the change restores both.
#[test]
fn a_point_is_taught_in_another_frame() {
    let mut controller = controller();
    let mut operator = Operator::default();
    let mut execute = |controller: &mut Controller, name: &str, arguments: Value| {
        let done = operator.execute(name, arguments.as_object().unwrap(), controller);
        done.map(|_| ()).map_err(|error| error.to_string())
    };
    let before = shown_point(&controller);
    execute(&mut controller, "teach", json!({ "name": "pPick", "key": 1, "tool": { "name": "flange", "key": null } }))
        .unwrap();
    let in_table = shown_point(&controller);
    let in_world =
        json!({ "name": "pPick", "key": 1, "tool": { "name": "flange", "key": null }, "frame": { "name": "world" } });
    execute(&mut controller, "teach", in_world).unwrap();
    let taught = shown_point(&controller);
    assert_eq!((&in_table["father"], &taught["father"]), (&json!("fTable"), &json!(null)));
    assert_ne!(in_table["local"], taught["local"]);
    let numbers = |value: &Value| -> Vec<f64> {
        value["pose"].as_array().unwrap().iter().map(|number| number.as_f64().unwrap()).collect()
    };
    let poses = numbers(&in_table).into_iter().zip(numbers(&taught));
    assert!(poses.clone().all(|(one, other)| (one - other).abs() < 1e-9), "{in_table} {taught}");
    execute(&mut controller, "undo", json!({})).unwrap();
    assert_eq!(shown_point(&controller), in_table);
    execute(&mut controller, "undo", json!({})).unwrap();
    assert_eq!(shown_point(&controller), before);
    let missing = json!({ "name": "pPick", "key": 1, "frame": { "name": "fNone" } });
    assert_eq!(
        execute(&mut controller, "teach", missing).unwrap_err(),
        "there is no frame `fNone` with a single value"
    );
}

#[test]
fn an_index_is_a_number_or_a_text() {
    let mut controller = controller();
    for (key, x) in [(json!(1), 100.0), (json!("1"), 200.0)] {
        let local = json!([x, 0, 0, 0, 0, 0]);
        run(&mut controller, "setPoint", json!({ "name": "pPick", "key": key, "local": local })).unwrap();
        assert_eq!(shown_point(&controller)["local"][0], x);
    }
    let mut refused = |key| run(&mut controller, "teach", json!({ "name": "pPick", "key": key })).unwrap_err();
    assert_eq!(refused(json!(2)), "there is no point `pPick[2]`");
    assert_eq!(refused(json!(null)), "there is no point `pPick` with a single value");
    for wrong in [json!(0.5), json!(-1), json!([1]), json!(true)] {
        assert!(refused(wrong).contains("whole number from 0"));
    }
}

#[test]
fn a_value_gets_the_present_position() {
    let mut controller = controller();
    run(&mut controller, "teach", json!({ "name": "pPick", "key": "1" })).unwrap();
    let here = crate::coordinates(&controller.arm().sample().pose);
    let pose = shown_point(&controller)["pose"].clone();
    let near = |(index, expected): (usize, &f64)| (pose[index].as_f64().unwrap() - expected).abs() < 1e-9;
    assert!(here.iter().enumerate().all(near), "{pose} {here:?}");
}

#[test]
fn a_point_gets_the_configuration_of_the_arm_except_for_fields_that_stay_the_same() {
    let mut controller = controller();
    controller.devices.state.arm.start_at([10.0, 20.0, 80.0, 0.0, -70.0, 0.0]).unwrap();
    run(&mut controller, "teach", json!({ "name": "pPick", "key": 1, "tool": { "name": "flange" } })).unwrap();
    assert_eq!(shown_point(&controller)["config"], "lefty esame wsame");
    let free = "pPick[1].config.elbow=efree\n  pPick[1].config.wrist=wpositive";
    let listing = LISTING.replace("pPick[1].config.shoulder=righty", free);
    let mut controller = Running::start(&listing).controller;
    controller.step();
    controller.devices.state.arm.start_at([10.0, 20.0, 80.0, 0.0, -70.0, 0.0]).unwrap();
    run(&mut controller, "teach", json!({ "name": "pPick", "key": 1 })).unwrap();
    assert_eq!(shown_point(&controller)["config"], "ssame epositive wnegative");
}

#[test]
fn joint_positions_are_taught_and_changes_are_undone() {
    let listing = LISTING.replace("frame fTable", "joint jHome\nframe fTable");
    let mut controller = Running::start(&listing).controller;
    controller.step();
    let taught = [10.0, 20.0, 80.0, 1.0, -70.0, 5.0];
    controller.devices.state.arm.start_at(taught).unwrap();
    let mut operator = Operator::default();
    let mut execute = |name: &str, arguments: Value, controller: &mut Controller| {
        let done = operator.execute(name, arguments.as_object().unwrap(), controller);
        done.map_err(|error| error.to_string()).map(|_| json!(operator.unsaved()))
    };
    let joints = |controller: &Controller| {
        positions::joints(&positions::data(controller), &controller.vm.space.memory).remove(0).values
    };
    let home = json!({ "name": "jHome", "key": null });
    let unsaved = execute("teach", json!({ "name": "jHome" }), &mut controller).unwrap();
    assert_eq!((joints(&controller), &unsaved["undo"]), (taught.to_vec(), &home));
    let moved = json!({ "name": "pPick", "key": 1, "local": [1, 2, 3, 0, 0, 0] });
    let unsaved = execute("setPoint", moved, &mut controller).unwrap();
    assert_eq!((unsaved["points"].as_array().unwrap().len(), &unsaved["undo"]["name"]), (2, &json!("pPick")));
    let unsaved = execute("undo", json!({}), &mut controller).unwrap();
    assert_eq!((&shown_point(&controller)["local"][0], &unsaved["points"]), (&json!(0.0), &json!([home])));
    let unsaved = execute("undo", json!({}), &mut controller).unwrap();
    assert_eq!((joints(&controller), unsaved), (vec![0.0; 6], json!({ "points": [], "undo": null })));
    assert_eq!(execute("undo", json!({}), &mut controller).unwrap_err(), "nothing was changed");
    let named = json!({ "name": "jHome", "local": [1, 2, 3, 0, 0, 0] });
    assert_eq!(
        execute("setPoint", named, &mut controller).unwrap_err(),
        "there is no point `jHome` with a single value"
    );
}

#[test]
fn values_out_of_reach_have_a_reason() {
    let listing = LISTING.replace("frame fTable", "joint jFar\njointRs jOther\ntool tLong\nframe fTable");
    let lines = "begin\n  link(tLong,flange)\n  tLong.trsf.z=5000\n  jFar={999,0,0,0,0,0}";
    let mut controller = Running::start(&listing.replace("begin", lines)).controller;
    controller.step();
    let mut operator = Operator::default();
    let mut query = |name: &str, arguments: Value| {
        json!(operator.execute(name, arguments.as_object().unwrap(), &mut controller).unwrap())
    };
    let teach = json!({ "name": "pPick", "key": 1, "tool": { "name": "flange" } });
    query("teach", teach);
    let far = &query("reach", json!({ "tool": { "name": "flange" } }))["unreachable"];
    let names: Vec<&str> = far.as_array().unwrap().iter().map(|value| value["name"].as_str().unwrap()).collect();
    let other = far.as_array().unwrap().iter().find(|value| value["name"] == "jOther");
    assert_eq!(other.unwrap()["reason"], "it is for another kind of arm");
    assert!(names.contains(&"jFar") && !far.to_string().contains(r#""key":"1""#), "{far}");
    let far = &query("reach", json!({ "tool": { "name": "tLong" } }))["unreachable"];
    let point = far.as_array().unwrap().iter().find(|value| value["key"] == "1").unwrap();
    assert!(point["reason"].as_str().unwrap().contains("from the shoulder"), "{point}");
    let solved = &query("solve", json!({ "name": "pPick", "key": 1, "tool": { "name": "tLong" } }))["solutions"];
    let is_far = |solution: &Value| solution["joints"].is_null() && solution["reason"].is_string();
    assert!(solved.as_array().unwrap().len() == 8 && solved.as_array().unwrap().iter().all(is_far), "{solved}");
}

#[test]
fn the_operator_acts_with_the_keys_of_scripts() {
    let mut controller = controller();
    run(&mut controller, "operate", json!({ "keys": { "power": true } })).unwrap();
    for wrong in [json!({}), json!({ "keys": 1 }), json!({ "keys": { "power": "x" } }), json!({ "keys": { "no": 1 } })]
    {
        assert!(run(&mut controller, "operate", wrong).is_err());
    }
}

#[test]
fn wrong_commands_say_why() {
    let mut controller = controller();
    let mut refused = |name: &str, arguments| run(&mut controller, name, arguments).unwrap_err();
    assert_eq!(refused("fly", json!({})), "`fly` is not a command");
    assert_eq!(refused("teach", json!({ "name": "pGone" })), "there is no point `pGone` with a single value");
    let far = json!({ "name": "pPick", "key": "1", "local": [99_999_999, 2, 3, 0, 0, 0] });
    assert!(refused("setPoint", far).contains("outside the range from -100000 to 100000 mm"));
    let tool = json!({ "name": "pPick", "key": "1", "tool": { "name": "tGone" } });
    assert_eq!(refused("teach", tool), "there is no tool `tGone` with a single value");
    let short = json!({ "name": "pPick", "key": "1", "local": [1, 2, 3] });
    assert!(refused("setPoint", short).contains("six numbers"));
}

#[test]
fn unsaved_values_survive_a_new_start() {
    let mut old = controller();
    let mut operator = Operator::default();
    let point = json!({ "name": "pPick", "key": "1", "local": [7, 8, 9, 0, 0, 0] });
    operator.execute("setPoint", point.as_object().unwrap(), &mut old).unwrap();
    let mut new = controller();
    assert_eq!(operator.carry(&old, &mut new), []);
    assert_eq!(shown_point(&new)["local"], json!([7.0, 8.0, 9.0, 0.0, 0.0, 0.0]));
    assert_eq!(operator.unsaved().points.len(), 1);

    let mut other = Running::start("num nOther\nprogram start()\nbegin\n  delay(1)\nend\n").controller;
    let lost = operator.carry(&new, &mut other);
    assert_eq!(lost, [PointName { name: "pPick".to_owned(), key: Some("1".to_owned()) }]);
    assert_eq!(operator.unsaved().points, []);
}

mod frames_and_tools;
mod inches;
mod laws;
