//! Clicks on HTML user pages, in scripts and in the served page.

use serde_json::{Value, json};

use crate::serve::{ServedRun, Viewer};
use crate::support::Folder;

const APPLICATION: &str = r#"version s8.10
num nCount
bool bDone
program start()
begin
  ? "other: "+toString("",userPage("other"))+", main: "+toString("",userPage("MAIN"))
  while !bDone
    delay(0.1)
  endWhile
end
program clkAdd()
begin
  nCount=nCount+1
  ? "clicked "+toString("",nCount)
  delay(1)
end
program clkDone()
begin
  bDone=true
end

=== main/interface/main.html
<html><body><label id="lblCount"/><button id="btnAdd"/><button id="btnDone"/></body></html>
=== main/interface/main.bindings.json
{"version":"1.0","bindings":[{"id":"lblCount","attribute":"innerHTML","data":"nCount[0]","size":1,"direction":"r"}],
"callbacks":[{"id":"btnAdd","event":"click","data":"clkAdd","priority":20},
{"id":"btnDone","event":"click","data":"clkDone","priority":10}]}
"#;

#[test]
fn scripts_click_on_elements() {
    let folder = Folder::with(APPLICATION);
    let script = "[[at]]\nt = 0.5\nclick = \"btnAdd\"\n[[at]]\nt = 1\nclick = \"btnAdd\"\n[[at]]\nt = 2\nclick = \"btnAdd\"\n[[at]]\nt = 3\nclick = \"btnDone\"\n";
    folder.write("clicks.toml", script);
    let run =
        folder.val3(&["run", "usrapp/main", "--script", "clicks.toml", "--until", "10", "--events", "events.jsonl"]);
    expect_test::expect![[r#"
        other: -1, main: 0
        clicked 1
        log: script, t = 1: the task `main.btnAdd.click_clkAdd` of an earlier click still runs
        clicked 2
    "#]]
    .assert_eq(&run.stdout);
    let events: Vec<Value> =
        folder.read("events.jsonl").lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    let tasks: Vec<&str> = events.iter().filter_map(|event| event["task"].as_str()).collect();
    assert!(tasks.contains(&"main.btnAdd.click_clkAdd"), "{tasks:?}");
    // The task of the first click is still running.
    let log = events.iter().filter(|event| event.to_string().contains("still runs")).count();
    assert_eq!(log, 1, "{events:?}");
}

#[test]
fn a_click_on_nothing_is_a_fault_of_the_script() {
    let folder = Folder::with(APPLICATION);
    folder.write("clicks.toml", "[[at]]\nt = 0.5\nclick = \"btnDon\"\n");
    let run = folder.val3(&["run", "usrapp/main", "--script", "clicks.toml", "--until", "10"]);
    expect_test::expect![[r#"
        error: the script `clicks.toml` cannot be used
          t = 0.5: no page executes a program by a click on `btnDon`; did you mean `btnDone`?
    "#]]
    .assert_eq(&run.stderr);
    assert_eq!(run.code, 2);
}

#[test]
fn the_served_page_clicks_on_elements() {
    let mut run = ServedRun::of(APPLICATION, &[]);
    let mut viewer = Viewer::new(&run.operator);
    let clicks = json!([{ "id": "btnAdd", "program": "clkAdd" }, { "id": "btnDone", "program": "clkDone" }]);
    let values = |count: &str| json!([{ "id": "lblCount", "attribute": "innerHTML", "value": count }]);
    assert_eq!(html(&mut viewer), json!({ "name": "main", "values": values("0"), "clicks": clicks }));
    let click = |id: &str| json!({ "id": 1, "command": "operate", "keys": { "click": id } });
    assert_eq!(viewer.command(click("btnAdd"))["error"], Value::Null);
    while viewer.next_of("page")["html"]["values"] != values("1") {}
    let answer = viewer.command(click("lblCount"));
    assert!(answer["error"].as_str().unwrap().contains("by a click on `lblCount`"), "{answer}");
    let mut guest = Viewer::new(&run.guest);
    assert!(guest.command(click("btnDone"))["error"].is_string());
    assert_eq!(viewer.command(click("btnDone"))["error"], Value::Null);
    run.wait_for("the run has ended");
    assert_eq!(viewer.next_of("end")["exitCode"], 0);
    run.signal(rustix::process::Signal::INT);
}

/// HTML of the next page that has some.
fn html(viewer: &mut Viewer) -> Value {
    loop {
        let page = viewer.next_of("page");
        if page["html"] != Value::Null {
            return page["html"].clone();
        }
    }
}
