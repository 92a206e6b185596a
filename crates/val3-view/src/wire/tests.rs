use jsonschema::Validator;
use serde::Deserialize as _;
use serde_json::json;
use val3_machine::event::EventKind;

use super::*;

fn validator() -> Validator {
    jsonschema::validator_for(&schema()).unwrap()
}

/// Validator for messages of the type `name`.
fn validator_of(name: &str) -> Validator {
    let mut schema = schema();
    let keys = schema.as_object_mut().unwrap();
    keys.insert("$ref".to_owned(), json!(format!("#/$defs/{name}")));
    jsonschema::validator_for(&schema).unwrap()
}

fn check(validator: &Validator, value: &Value) {
    let errors: Vec<String> = validator.iter_errors(value).map(|error| error.to_string()).collect();
    assert_eq!(errors, [""; 0], "{value:#}");
}

#[test]
fn small_messages_follow_the_schema() {
    let print = Event { t: 0.5, task: None, at: None, kind: EventKind::Print { text: "ready".to_owned() } };
    let point = PointName { name: "pPick".to_owned(), key: None };
    let validator = validator();
    for message in [
        Message::Clock(Clock { t: 1.0, speed: PaceSpeed::Fastest(Fastest::Max), is_paused: false, is_stopped: false }),
        Message::Clock(Clock { t: 1.0, speed: PaceSpeed::Times(2.0), is_paused: true, is_stopped: true }),
        Message::Events(EventsMessage { events: vec![PageEvent { event: print, line_code: None }] }),
        Message::Unsaved(UnsavedMessage { points: vec![point.clone()], undo: Some(point) }),
        Message::End(End { t: 2.0, reason: EndReason::Limit, exit_code: 3 }),
        Message::Rewind(Rewind { t: 0.0 }),
        Message::Past(Past { from: 0.0, to: 60.004 }),
        Message::Answer(Answer { id: json!(1), error: None, more: Map::from_iter([("files".to_owned(), json!([]))]) }),
        Message::Samples(Samples { base64: "AA==".to_owned() }),
        Message::Select(Select { name: None }),
    ] {
        check(&validator, &json!(message));
    }
}

#[test]
fn a_renamed_key_is_found() {
    assert!(!validator().is_valid(&json!({ "kind": "clock", "t": 1.0, "speed": 1.0, "paused": false })));
    assert!(!validator().is_valid(&json!({ "kind": "other" })));
}

#[test]
fn commands_follow_the_schema() {
    let validator = validator_of("Command");
    for command in [
        json!({ "command": "operate", "keys": { "power": true } }),
        json!({ "command": "setPoint", "name": "pPick", "key": 1, "local": [0, 1, 2, 3, 4, 5] }),
        json!({ "command": "teach", "name": "pPick", "key": "1" }),
        json!({ "command": "teach", "name": "jHome", "tool": { "name": "flange" } }),
        json!({ "command": "solve", "name": "pPick", "tool": { "name": "tTools", "key": 1 } }),
        json!({ "command": "teachFrame", "name": "fTable", "joints": [[0.0], [1.0], [2.0]], "tool": { "name": "tA" } }),
        json!({ "command": "teachTool", "name": "tTools", "key": 1, "joints": [[0.0], [1.0], [2.0], [3.0]] }),
        json!({ "command": "undo" }),
        json!({ "command": "reach", "tool": { "name": "tGripper", "key": null } }),
        json!({ "command": "save" }),
        json!({ "command": "userPage", "to": "next" }),
        json!({ "command": "pace", "isPaused": true, "speed": "max" }),
        json!({ "command": "cycle", "cycles": 2 }),
        json!({ "command": "record", "name": "first" }),
        json!({ "command": "run" }),
        json!({ "command": "run", "atInitialPosition": true }),
    ] {
        check(&validator, &command);
        assert!(Command::deserialize(&command).is_ok(), "{command}");
    }
    assert!(!validator.is_valid(&json!({ "command": "record", "scenario": "first" })));
}

#[test]
fn responses_follow_the_schema() {
    check(&validator_of("Saved"), &json!(Saved::Conflict(vec!["a.dtx".to_owned()])));
    let (file, text) = ("tests/first.toml".to_owned(), String::new());
    let reason = Some("axis 1 would be at 200".to_owned());
    let solution = ArmSolution { config: None, joints: None, reason, is_chosen: false };
    check(&validator_of("Solved"), &json!(Solved { solutions: vec![solution] }));
    check(&validator_of("TaughtTool"), &json!(TaughtTool { residual: 0.1 }));
    let value = UnreachableValue { name: "pFar".to_owned(), key: None, reason: "too far".to_owned() };
    check(&validator_of("Reached"), &json!(Reached { unreachable: vec![value] }));
    check(&validator_of("Recorded"), &json!(Recorded { file, text, remarks: vec![] }));
}
