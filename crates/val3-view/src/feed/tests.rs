use std::collections::BTreeMap;

use serde_json::{Value, json};
use val3_machine::controller::RunStatus;
use val3_tests::running::Running;

use super::*;

const LISTING: &str = r#"
frame fTable
point pPick[2]
tool tGrip
joint jHome
mdesc mFast
num nCount

program start()
begin
  link(fTable,world)
  fTable.trsf={500,0,300,0,0,0}
  link(pPick[1],fTable)
  pPick[1].trsf={0,100,50,0,0,0}
  pPick[1].config.shoulder=righty
  pPick[1].config.wrist=wpositive
  tGrip.trsf={0,0,120,0,0,0}
  jHome={0,0,90,0,90,0}
  title("cell")
  putln("ready")
  taskCreate "other",10,other()
  delay(0.2)
  movej(jHome,tGrip,mFast)
  waitEndMove()
end

program other()
begin
  while true
    nCount=nCount+1
    delay(0.1)
  endWhile
end
"#;

const FAILING: &str = r#"
num nList[3]

program start()
begin
  taskCreate "other",10,other()
  delay(0.2)
  nList[7]=1
end

program other()
begin
  delay(10)
end
"#;

/// Stands for the code of a line.
fn line(file: &str, line: u32) -> Option<String> {
    let (_, program) = file.rsplit_once('/')?;
    Some(format!("{program} {line}"))
}

/// All messages of the first second of a run.
fn run(listing: &str) -> Vec<ViewerMessage> {
    let mut controller = Running::start(listing).controller;
    let mut feed = Feed::new(&controller, Role::Operator, line);
    while controller.now() < 1_000_000_000 {
        let start = controller.now();
        if let RunStatus::Waiting(Some(wake)) = controller.step() {
            controller.jump(wake.min(start + CYCLE));
        }
        let events = controller.devices.take_events();
        feed.see(start, &events, &controller);
    }
    feed.end(EndReason::Limit, 3, &controller);
    feed.take()
}

fn objects<'m>(messages: &'m [ViewerMessage], kind: &'m str) -> impl Iterator<Item = &'m Value> {
    messages.iter().filter_map(move |message| match message {
        ViewerMessage::Object(value) if value["kind"] == kind => Some(value),
        _ => None,
    })
}

#[test]
fn a_run_begins_with_its_scene_and_its_whole_state() {
    let messages = run(LISTING);
    let kinds: Vec<&str> = messages
        .iter()
        .map(|message| match message {
            ViewerMessage::Object(value) => value["kind"].as_str().unwrap(),
            ViewerMessage::Samples(_) => "samples",
        })
        .take(5)
        .collect();
    assert_eq!(kinds, ["scene", "tool", "samples", "motion", "state"]);
    let scene = objects(&messages, "scene").next().unwrap();
    assert_eq!(scene["arm"]["axes"].as_array().unwrap().len(), 6);
    let page = objects(&messages, "page").last().unwrap();
    assert_eq!((&page["title"], &page["lines"][0]), (&json!("cell"), &json!("ready")));
    let end = messages.last().unwrap();
    assert_eq!(end, &ViewerMessage::Object(json!({ "kind": "end", "t": 1.0, "reason": "limit", "exitCode": 3 })));
}

#[test]
fn tasks_appear_in_the_state() {
    let messages = run(LISTING);
    let last = objects(&messages, "state").last().unwrap();
    let tasks = last["tasks"].as_array().unwrap();
    let other = tasks.iter().find(|task| task["name"] == "other").unwrap();
    assert_eq!((&other["priority"], &other["period"], &other["program"]), (&json!(10), &Value::Null, &json!("other")));
}

#[test]
fn tasks_at_rest_and_errors_have_the_code_of_their_line() {
    let messages = run(FAILING);
    let states: Vec<&Value> = objects(&messages, "state").map(|state| &state["tasks"][0]).collect();
    assert_eq!((&states[1]["state"], &states[1]["lineCode"]), (&json!("waiting"), &json!("start.pgx 6")));
    let last = states.last().unwrap();
    assert_eq!(
        (&last["state"], &last["error"], &last["lineCode"]),
        (&json!("error"), &json!(20), &json!("start.pgx 7"))
    );
    let mut events = objects(&messages, "events").flat_map(|message| message["events"].as_array().unwrap());
    let error = events.find(|event| event["kind"] == "error").unwrap();
    assert_eq!((&error["lineCode"], &error["task"]), (&json!("start.pgx 7"), &json!("main~")));
    assert!(error["help"].as_str().unwrap().contains("size"), "{error}");
}

/// What a page shows after messages: the latest message of each kind that contains everything, and the latest values of
/// signals and data, without times.
fn shown(messages: &[ViewerMessage]) -> BTreeMap<String, Value> {
    let mut shown = BTreeMap::new();
    for message in messages {
        let ViewerMessage::Object(message) = message else { continue };
        let kind = message["kind"].as_str().unwrap();
        match kind {
            "state" | "motion" | "page" | "parts" => {
                let mut message = message.clone();
                message["t"] = Value::Null;
                shown.insert(kind.to_owned(), message);
            }
            "io" => {
                for change in message["changes"].as_array().unwrap() {
                    shown.insert(change["link"].to_string(), change.clone());
                }
            }
            "scene" | "data" => {
                for group in ["points", "joints", "frames", "tools"] {
                    for value in message[group].as_array().unwrap() {
                        let name = format!("{group} {} {}", value["name"], value["key"]);
                        shown.insert(name, value.clone());
                    }
                }
            }
            _ => {}
        }
    }
    shown
}

#[test]
fn a_complete_state_contains_nothing_new_and_everything() {
    let mut running = Running::start(LISTING);
    running.controller.devices.state.robot.set_power(true);
    let mut feed = Feed::new(&running.controller, Role::Operator, line);
    let (mut messages, mut next) = (Vec::new(), 50_000_000);
    while running.controller.now() < 2_000_000_000 {
        let start = running.controller.now();
        if let RunStatus::Waiting(Some(wake)) = running.controller.step() {
            running.controller.jump(wake.min(start + CYCLE));
        }
        let events = running.controller.devices.take_events();
        feed.see(start, &events, &running.controller);
        if start >= next {
            next += 130_000_000;
            let state = feed.complete_state(&running.controller);
            messages.extend(feed.take());
            let mut from_state = shown(&messages[..1]);
            from_state.extend(shown(&state));
            assert_eq!(from_state, shown(&messages), "{start} ns");
            assert!(matches!(state.last(), Some(ViewerMessage::Samples(_))));
            assert!(objects(&state, "tool").chain(objects(&state, "source")).next().is_none());
        }
    }
}

#[test]
fn equal_runs_have_equal_messages() {
    assert_eq!(run(LISTING), run(LISTING));
}

#[test]
fn an_arm_that_rests_has_one_sample() {
    let messages = run("program start()\nbegin\n  delay(10)\nend\n");
    let samples = messages.iter().filter(|message| matches!(message, ViewerMessage::Samples(_)));
    assert_eq!(samples.count(), 1);
}

#[test]
fn a_run_that_goes_back_forgets_what_followed() {
    let mut controller = Running::start(LISTING).controller;
    let snapshot = controller.snapshot();
    let mut feed = Feed::new(&controller, Role::Debugger, line);
    while controller.now() < 50_000_000 {
        controller.step();
    }
    feed.refresh(&controller);
    feed.take();
    feed.refresh(&controller);
    assert_eq!(feed.take(), []);
    controller.restore(&snapshot);
    feed.refresh(&controller);
    let messages = feed.take();
    assert_eq!(messages.first(), Some(&ViewerMessage::Object(json!({ "kind": "rewind", "t": 0.0 }))));
    let page = objects(&messages, "page").next().unwrap();
    assert_eq!(page["lines"][0], "");
    assert!(objects(&messages, "state").count() == 1);
}

#[test]
fn points_have_their_configuration() {
    let messages = run(LISTING);
    let known = objects(&messages, "data").flat_map(|data| data["points"].as_array().unwrap());
    let last = known.filter(|point| point["key"] == "1").last().unwrap();
    assert_eq!(last["config"], "righty esame wpositive");
}

#[test]
fn tools_have_the_name_of_their_data() {
    let mut running = Running::start(LISTING);
    running.controller.devices.state.robot.set_power(true);
    let mut feed = Feed::new(&running.controller, Role::Operator, line);
    while running.controller.now() < 2_000_000_000 {
        let start = running.controller.now();
        if let RunStatus::Waiting(Some(wake)) = running.controller.step() {
            running.controller.jump(wake.min(start + CYCLE));
        }
        feed.see(start, &[], &running.controller);
    }
    let messages = feed.take();
    let names: Vec<_> =
        objects(&messages, "tool").map(|tool| (&tool["name"], tool["pose"][2].as_f64().unwrap().round())).collect();
    assert_eq!(names, [(&json!("flange"), 0.0), (&json!("tGrip"), 120.0)]);
    let paths = objects(&messages, "motion").filter_map(|motion| motion["path"].as_array());
    assert!(paths.flatten().any(|piece| piece["phase"] == "nominal" && piece["points"].as_array().unwrap().len() > 2));
}

#[test]
fn messages_of_a_run_follow_the_schema() {
    let validator = jsonschema::validator_for(&wire::schema()).unwrap();
    let messages = run(LISTING);
    for kind in ["scene", "tool", "state", "motion", "page", "data", "end"] {
        assert!(objects(&messages, kind).count() > 0, "{kind}");
        for message in objects(&messages, kind) {
            let errors: Vec<String> = validator.iter_errors(message).map(|error| error.to_string()).collect();
            assert_eq!(errors, [""; 0], "{message:#}");
        }
    }
}
