//! Command `record` of a page: a scenario of a served run.

use std::thread;
use std::time::Duration;

use rustix::process::Signal;
use serde_json::{Value, json};

use crate::serve::{ServedRun, Viewer};

const CODE: &str = "num nKey\nstring sName\ntitle(\"Cell\")\nnKey=get()\n? \"key \"+toString(\"\",nKey)\ndelay(3600)\n";

fn record(id: u32, name: &str) -> Value {
    json!({ "id": id, "command": "record", "name": name })
}

#[test]
fn a_running_application_becomes_a_scenario_that_passes() {
    let mut run = ServedRun::of(CODE, &[]);
    let mut viewer = Viewer::new(&run.operator);
    let key = json!({ "id": 1, "command": "operate", "keys": { "key": "F1" } });
    assert_eq!(viewer.command(key)["error"], Value::Null);
    assert_eq!(viewer.next_print().1, "key 271");
    let answer = viewer.command(record(2, "oneKey"));
    assert_eq!((&answer["error"], &answer["file"]), (&Value::Null, &json!("usrapp/tests/oneKey.toml")), "{answer}");
    assert_eq!(answer["remarks"], json!([]));
    let text = run.folder.read("usrapp/tests/oneKey.toml");
    assert_eq!(answer["text"], text);
    for part in ["key = \"F1\"", "until = ", "\"key 271\"", "\"Cell\""] {
        assert!(text.contains(part), "{part}: {text}");
    }
    let tested = run.folder.val3(&["test", "usrapp/tests/oneKey.toml"]);
    assert_eq!(tested.code, 0, "{tested:?}");
    // The run was not disturbed, and an existing scenario is not replaced.
    let again = viewer.command(record(3, "oneKey"));
    assert!(again["error"].as_str().unwrap().contains("it exists, and is not replaced"), "{again}");
    for (name, expected) in [("../oneKey", "is not the name of a scenario"), ("", "is not the name of a scenario")] {
        let answer = viewer.command(record(4, name));
        assert!(answer["error"].as_str().unwrap().contains(expected), "{answer}");
    }
    let unnamed = viewer.command(json!({ "id": 5, "command": "record" }));
    assert_eq!(unnamed["error"], "`name` is the name of the scenario");
    assert_eq!(run.folder.read("usrapp/tests/oneKey.toml"), text);
    let mut guest = Viewer::new(&run.guest);
    assert_ne!(guest.command(record(6, "byGuest"))["error"], Value::Null);
    run.signal(Signal::INT);
    assert_eq!(run.ending().0, 130);
}

#[test]
fn an_ended_run_becomes_a_scenario() {
    let mut run = ServedRun::of("? \"done\"\n", &[]);
    run.wait_for("the run has ended");
    let mut viewer = Viewer::new(&run.operator);
    let answer = viewer.command(record(1, "ended"));
    assert_eq!(answer["error"], Value::Null, "{answer}");
    let text = run.folder.read("usrapp/tests/ended.toml");
    assert!(text.contains("\"done\"") && !text.contains("until"), "{text}");
    run.signal(Signal::INT);
    assert_eq!(run.ending().0, 0);
}

/// The scenario lasts up to the present time, although the run has had no events.
#[test]
fn a_quiet_run_is_recorded_up_to_now() {
    let mut run = ServedRun::of("delay(3600)\n", &[]);
    let mut viewer = Viewer::new(&run.operator);
    // The controller's clock follows real time.
    thread::sleep(Duration::from_millis(200));
    let paused = viewer.command(json!({ "id": 1, "command": "pace", "isPaused": true }));
    assert_eq!(paused["error"], Value::Null, "{paused}");
    let now = Viewer::new(&run.guest).paused_clock()["t"].as_f64().unwrap();
    assert!(now > 0.05, "{now}");
    let answer = viewer.command(record(2, "quiet"));
    assert_eq!(answer["error"], Value::Null, "{answer}");
    let remarks = answer["remarks"].as_array().unwrap();
    assert!(remarks.iter().any(|remark| remark.as_str().unwrap().starts_with("Nothing is expected")), "{answer}");
    let text = answer["text"].as_str().unwrap();
    assert!(text.contains("# Nothing is expected"), "{text}");
    let until: f64 = text.lines().find_map(|line| line.strip_prefix("until = ")).unwrap().parse().unwrap();
    assert!((now..now + 0.0011).contains(&until), "{now} {text}");
    run.signal(Signal::INT);
    assert_eq!(run.ending().0, 130);
}

/// The arm stays where the first run has ended, so that the scenario of the second run begins there.
#[test]
fn a_run_that_has_started_again_becomes_a_scenario_from_its_own_position() {
    let code = "joint jA\nmdesc mA\ntool tA\njA=herej()\n? jA.j1\nmovej({60,0,90,0,30,0},tA,mA)\nwaitEndMove()\n";
    let run = ServedRun::of(code, &["--arm", "TX2-60L", "--power"]);
    let mut viewer = Viewer::new(&run.operator);
    viewer.next_of("end");
    assert_eq!(viewer.command(json!({ "id": 1, "command": "run" }))["error"], Value::Null);
    viewer.next_of("end");
    let answer = viewer.command(record(2, "again"));
    assert_eq!((&answer["error"], &answer["remarks"]), (&Value::Null, &json!([])), "{answer}");
    let text = run.folder.read("usrapp/tests/again.toml");
    assert!(text.contains("start = [60, 0, 90, 0, 30, 0]") && text.contains("\"60\""), "{text}");
}
