//! `val3 run` with a conveyor: parts arrive, queue up at the end, and are picked by a gripper.

use serde_json::Value;

use crate::support::Folder;

/// An application with a belt in front of the arm. The flange at `jPick` is 100 mm above the first part in the queue.
const LISTING: &str = r#"
wait(isPowered())
dBelt=true
movej(jPick,flange,mStop)
waitEndMove()
wait(dPart==true)
dValve=true
delay(0.1)
movej(jAway,flange,mStop)
waitEndMove()
delay(3)

=== main/main.dtx
<?xml version="1.0" encoding="utf-8"?>
<Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
  <Datas>
    <Data name="dBelt" access="private" xsi:type="array" type="dio" size="1">
      <Value key="0" link="Io\%Q0" />
    </Data>
    <Data name="dPart" access="private" xsi:type="array" type="dio" size="1">
      <Value key="0" link="Io\%I0" />
    </Data>
    <Data name="dValve" access="private" xsi:type="array" type="dio" size="1">
      <Value key="0" link="Io\%Q1" />
    </Data>
    <Data name="jAway" access="private" xsi:type="array" type="jointRx" size="1">
      <Value key="0" j1="90" j3="90" j5="90" />
    </Data>
    <Data name="jPick" access="private" xsi:type="array" type="jointRx" size="1">
      <Value key="0" j3="90" j5="90" />
    </Data>
    <Data name="mStop" access="private" xsi:type="array" type="mdesc" size="1">
      <Value key="0" blend="off" />
    </Data>
  </Datas>
</Database>
"#;

/// A belt along the y axis. The first part in the queue is below the flange of the TX2-60L at `jPick`, which is at
/// x = 450, y = 20, z = 330.
const CELL: &str = "[[conveyor]]\nname = \"belt\"\nbox = { min = [-150, -800, -20], max = [150, 50, 0] }\nat = [450, 0, 180]\n\
    speed = [0, 250, 0]\nwhen = { io = { 'Io\\%Q0' = true } }\n\
    feed = { part = \"bag\", every = 1, at = [0, -600, 50] }\n\
    [[part]]\nname = \"bag\"\nbox = [100, 100, 100]\ncopies = 3\n\
    [[gripper]]\nwhen = { io = { 'Io\\%Q1' = true } }\nwithin = 60\n\
    [[sensor]]\nname = \"at end\"\nin = \"belt frame\"\nbeam = { from = [-140, 0, 50], to = [140, 0, 50] }\nio = 'Io\\%I0'\n\
    [[object]]\nname = \"belt frame\"\nat = [450, 0, 180]\nbox = { min = [-150, -800, -60], max = [150, 50, -20] }\n";

/// A folder with the application and the belt.
pub(crate) fn folder() -> Folder {
    let folder = Folder::with(LISTING);
    folder.write("val3.toml", "arm = \"tx2-60l\"\n[run]\npower = true\n");
    folder.write("cell.toml", CELL);
    folder
}

/// Events of a run about parts and grippers, each with its time in seconds: `1.5 part bag[0]`.
fn events(folder: &Folder) -> Vec<String> {
    folder.val3(&["run", "--events", "events.jsonl"]);
    let text = folder.read("events.jsonl");
    let events = text.lines().filter_map(|line| serde_json::from_str::<Value>(line).ok());
    let shown = events.filter_map(|event| {
        let kind = event["kind"].as_str().filter(|kind| matches!(*kind, "part" | "grip" | "sensor"))?;
        let of = event["part"].as_str().or_else(|| event["sensor"].as_str()).unwrap_or("nothing");
        let detected = event["detects"].as_str().map(|part| format!(" {part}")).unwrap_or_default();
        Some(format!("{} {kind} {of}{detected}", event["t"]))
    });
    shown.collect()
}

#[test]
fn parts_arrive_queue_up_and_are_taken() {
    let folder = folder();
    expect_test::expect![[r#"
        0.004 part bag[0]
        1.004 part bag[1]
        2.004 part bag[2]
        2.204 sensor at end bag[0]
        2.208 grip bag[0]
        2.448 sensor at end
        3.204 sensor at end bag[1]"#]]
    .assert_eq(&events(&folder).join("\n"));
}

#[test]
fn two_runs_have_the_same_events() {
    let folder = folder();
    folder.val3(&["run", "--events", "first.jsonl"]);
    folder.val3(&["run", "--events", "second.jsonl"]);
    assert_eq!(folder.read("first.jsonl"), folder.read("second.jsonl"));
}
