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
    let points =
        PositionComputer::new(&positions::data(controller), &controller.vm.space.memory).of_type(BaseType::Point);
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
fn the_present_position_is_taught() {
    let mut controller = controller();
    run(&mut controller, "teach", json!({ "name": "pPick", "key": "1" })).unwrap();
    let here = crate::coordinates(&controller.arm().sample().pose);
    let pose = shown_point(&controller)["pose"].clone();
    let near = |(index, expected): (usize, &f64)| (pose[index].as_f64().unwrap() - expected).abs() < 1e-9;
    assert!(here.iter().enumerate().all(near), "{pose} {here:?}");
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
