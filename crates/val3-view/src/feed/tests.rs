use std::collections::BTreeMap;

use serde_json::{Value, json};
use val3_machine::controller::RunStatus;
use val3_test::{Fixture, ROOT};
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

/// Returns a listing's file.
fn file_of(listing: &str, file: &str) -> Option<String> {
    let path = file.strip_prefix(ROOT)?.strip_prefix('/')?;
    let files = Fixture::parse(listing).files;
    files.into_iter().find(|(known, _)| known == path).map(|(_, text)| text)
}

fn text(file: &str) -> Option<String> {
    file_of(LISTING, file)
}

/// All messages of the first second of a run.
fn run(listing: &str, files: FileReader) -> Vec<ViewerMessage> {
    let mut controller = Running::start(listing).controller;
    let mut feed = Feed::new(&controller, Role::Operator, files);
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
    let messages = run(LISTING, text);
    let kinds: Vec<&str> = messages
        .iter()
        .map(|message| match message {
            ViewerMessage::Object(value) => value["kind"].as_str().unwrap(),
            ViewerMessage::Samples(_) => "samples",
        })
        .take(6)
        .collect();
    assert_eq!(kinds, ["scene", "tool", "samples", "motion", "programs", "state"]);
    let scene = objects(&messages, "scene").next().unwrap();
    assert_eq!(scene["arm"]["axes"].as_array().unwrap().len(), 6);
    let page = objects(&messages, "page").last().unwrap();
    assert_eq!((&page["title"], &page["lines"][0]), (&json!("cell"), &json!("ready")));
    let end = messages.last().unwrap();
    assert_eq!(end, &ViewerMessage::Object(json!({ "kind": "end", "t": 1.0, "reason": "limit", "exitCode": 3 })));
}

#[test]
fn programs_have_their_code_once() {
    let messages = run(LISTING, text);
    let programs: Vec<&Value> = objects(&messages, "programs").collect();
    let [message] = programs.as_slice() else { panic!("{programs:?}") };
    assert_eq!(message["application"], "main");
    let other = message["programs"].as_array().unwrap().iter().find(|program| program["name"] == "other").unwrap();
    let code = other["code"].as_array().unwrap();
    assert_eq!(code.len(), 6);
    assert_eq!(code[1], json!([["text", "  "], ["keyword", "while"], ["text", " "], ["keyword", "true"]]));
    // The task is at a line of the code, which is the line in its message.
    let state = objects(&messages, "state").last().unwrap();
    let task = state["tasks"].as_array().unwrap().iter().find(|task| task["name"] == "other").unwrap();
    assert_eq!(task["file"], other["file"]);
    let row = usize::try_from(task["line"].as_u64().unwrap() - other["line"].as_u64().unwrap()).unwrap();
    assert_eq!(code[row], json!([["text", "    delay("], ["number", "0.1"], ["text", ")"]]));
    assert_eq!(objects(&run(LISTING, |_| None), "programs").count(), 0);
}

#[test]
fn tasks_appear_in_the_state() {
    let messages = run(LISTING, text);
    let last = objects(&messages, "state").last().unwrap();
    let tasks = last["tasks"].as_array().unwrap();
    let other = tasks.iter().find(|task| task["name"] == "other").unwrap();
    assert_eq!((&other["priority"], &other["period"], &other["program"]), (&json!(10), &Value::Null, &json!("other")));
}

#[test]
fn tasks_have_their_calling_lines() {
    const CALLING: &str = "program start()\nbegin\n  call inner(5)\nend\n\n\
                           program inner(num x_nLeft)\nbegin\n  if x_nLeft>0\n    call inner(x_nLeft-1)\n  endIf\n  delay(10)\nend\n";
    let messages = run(CALLING, |_| None);
    let callers = &objects(&messages, "state").last().unwrap()["tasks"][0]["callers"];
    let callers =
        callers.as_array().unwrap().iter().map(|caller| (&caller["program"], caller["line"].as_u64().unwrap()));
    let callers: Vec<_> = callers.collect();
    assert_eq!(callers.len(), 6);
    assert_eq!(callers[0].0, &json!("inner"));
    assert_eq!(callers[5].0, &json!("start"));
    assert!(callers[0].1 == callers[4].1 && callers[5].1 > 1, "{callers:?}");
}

#[test]
fn tasks_at_rest_and_errors_have_the_code_of_their_line() {
    let messages = run(FAILING, |file| file_of(FAILING, file));
    let states: Vec<&Value> = objects(&messages, "state").map(|state| &state["tasks"][0]).collect();
    assert_eq!((&states[1]["state"], &states[1]["lineCode"]), (&json!("waiting"), &json!("delay(0.2)")));
    let last = states.last().unwrap();
    assert_eq!(
        (&last["state"], &last["error"], &last["lineCode"]),
        (&json!("error"), &json!(20), &json!("nList[7]=1"))
    );
    let mut events = objects(&messages, "events").flat_map(|message| message["events"].as_array().unwrap());
    let error = events.find(|event| event["kind"] == "error").unwrap();
    assert_eq!((&error["lineCode"], &error["task"]), (&json!("nList[7]=1"), &json!("main~")));
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
    let mut feed = Feed::new(&running.controller, Role::Operator, text);
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
    assert_eq!(run(LISTING, text), run(LISTING, text));
}

/// No later cycle would send the samples of a batch that is not full.
#[test]
fn no_sample_waits_while_the_clock_stands_still() {
    let mut running = Running::start(LISTING);
    running.controller.devices.state.robot.set_power(true);
    let mut feed = Feed::new(&running.controller, Role::Operator, text);
    let mut waiting = 0;
    while running.controller.now() < 1_000_000_000 {
        let start = running.controller.now();
        running.controller.step();
        running.controller.jump(start + CYCLE);
        feed.see(start, &[], &running.controller);
        if start.is_multiple_of(5 * CYCLE) {
            waiting += usize::from(!feed.batch.is_empty());
            feed.rest(&running.controller);
            assert!(feed.batch.is_empty(), "{start} ns");
        }
    }
    assert!(waiting > 10, "{waiting} moments of a motion");
}

#[test]
fn an_arm_that_rests_has_one_sample() {
    let messages = run("program start()\nbegin\n  delay(10)\nend\n", |_| None);
    let samples = messages.iter().filter(|message| matches!(message, ViewerMessage::Samples(_)));
    assert_eq!(samples.count(), 1);
}

#[test]
fn a_run_that_goes_back_forgets_what_followed() {
    let mut controller = Running::start(LISTING).controller;
    let snapshot = controller.snapshot();
    let mut feed = Feed::new(&controller, Role::Debugger, text);
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
    let messages = run(LISTING, text);
    let known = objects(&messages, "data").flat_map(|data| data["points"].as_array().unwrap());
    let last = known.filter(|point| point["key"] == "1").last().unwrap();
    assert_eq!(last["config"], "righty esame wpositive");
}

/// All messages of the first two seconds of a run with power.
fn run_with_power(listing: &str) -> Vec<ViewerMessage> {
    let mut running = Running::start(listing);
    running.controller.devices.state.robot.set_power(true);
    let mut feed = Feed::new(&running.controller, Role::Operator, text);
    while running.controller.now() < 2_000_000_000 {
        let start = running.controller.now();
        if let RunStatus::Waiting(Some(wake)) = running.controller.step() {
            running.controller.jump(wake.min(start + CYCLE));
        }
        feed.see(start, &[], &running.controller);
    }
    feed.take()
}

#[test]
fn values_out_of_reach_are_those_of_the_last_tool() {
    for (length, is_expected) in [("120", false), ("3000", true)] {
        let messages = run_with_power(&LISTING.replace("tGrip.trsf={0,0,120,", &format!("tGrip.trsf={{0,0,{length},")));
        let found: Vec<&Value> = objects(&messages, "reach").collect();
        let last = *found.last().unwrap();
        let is_far = last["unreachable"].to_string().contains(r#""key":"1","name":"pPick""#);
        assert_eq!((&last["tool"], is_far), (&json!(1), is_expected), "{last:#}");
        assert_eq!((found.len(), &found[0]["tool"]), (2, &json!(0)), "a message for each tool");
    }
}

#[test]
fn tools_have_the_name_of_their_data() {
    let messages = run_with_power(LISTING);
    let names: Vec<_> =
        objects(&messages, "tool").map(|tool| (&tool["name"], tool["pose"][2].as_f64().unwrap().round())).collect();
    assert_eq!(names, [(&json!("flange"), 0.0), (&json!("tGrip"), 120.0)]);
    let paths = objects(&messages, "motion").filter_map(|motion| motion["path"].as_array());
    assert!(paths.flatten().any(|piece| piece["phase"] == "nominal" && piece["points"].as_array().unwrap().len() > 2));
}

#[test]
fn messages_of_a_run_follow_the_schema() {
    let validator = jsonschema::validator_for(&wire::schema()).unwrap();
    let messages = run(LISTING, text);
    for kind in ["scene", "tool", "programs", "state", "motion", "page", "data", "reach", "end"] {
        assert!(objects(&messages, kind).count() > 0, "{kind}");
        for message in objects(&messages, kind) {
            let errors: Vec<String> = validator.iter_errors(message).map(|error| error.to_string()).collect();
            assert_eq!(errors, [""; 0], "{message:#}");
        }
    }
}
