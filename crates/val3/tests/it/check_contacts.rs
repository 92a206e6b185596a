//! `val3 check` with a `cell.toml`: contacts that `--motion` finds are contacts of `val3 run`, and faults of the file.

use std::collections::BTreeSet;

use expect_test::expect;
use serde_json::Value;

use crate::support::Folder;

/// Moves to three points, along straight lines and joint by joint, with a stop at each point.
const CODE: &str = r#"
version s7.11
wait(isPowered())
movej(jReady,tGrip,mStop)
movel(pX[0],tGrip,mStop)
movel(pX[1],tGrip,mStop)
movej(pX[2],tGrip,mStop)
movej(jReady,tGrip,mStop)
waitEndMove()

=== main/main.dtx
<?xml version="1.0" encoding="utf-8"?>
<Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
  <Datas>
    <Data name="fPost" access="private" xsi:type="array" type="frame" size="1">
      <Value key="0" x="PLACE" fatherId="world[0]" />
    </Data>
    <Data name="jReady" access="private" xsi:type="array" type="jointRx" size="1">
      <Value key="0" j3="90" j5="90" />
    </Data>
    <Data name="mStop" access="private" xsi:type="array" type="mdesc" size="1">
      <Value key="0" blend="off" />
    </Data>
    <Data name="pX" access="private" xsi:type="array" type="pointRx" size="3">
      <Value key="0" x="400" y="200" z="200" rx="180" shoulder="lefty" elbow="epositive" wrist="wpositive" fatherId="world[0]" />
      <Value key="1" x="400" y="-200" z="200" rx="180" shoulder="lefty" elbow="epositive" wrist="wpositive" fatherId="world[0]" />
      <Value key="2" x="300" y="-300" z="300" rx="180" shoulder="lefty" elbow="epositive" wrist="wpositive" fatherId="world[0]" />
    </Data>
    <Data name="tGrip" access="private" xsi:type="array" type="tool" size="1">
      <Value key="0" z="60" fatherId="flange[0]" ioLink="valve1" />
    </Data>
  </Datas>
</Database>
"#;

const CELL: &str = r#"
[[object]]
name = "post"
in = "fPost"
box = { min = [-20, -20, -400], max = [20, 20, 250] }

[[object]]
name = "gripper"
in = "tGrip"
capsule = { from = [0, 0, -50], to = [0, 0, 0], radius = 15 }
"#;

fn folder(place: i32) -> Folder {
    let folder = Folder::with(&CODE.replace("PLACE", &place.to_string()));
    folder.write("val3.toml", "arm = \"tx2-60l\"\n[run]\npower = true\n");
    folder.write("cell.toml", CELL);
    folder
}

/// Pairs that touch in a run, from its events.
fn touching(folder: &Folder) -> BTreeSet<[String; 2]> {
    folder.val3(&["run", "--events", "events.jsonl"]);
    let events = folder.read("events.jsonl");
    let events = events.lines().filter_map(|line| serde_json::from_str::<Value>(line).ok());
    let contacts = events.filter(|event| event["kind"] == "clearance" && event["state"] == "contact");
    contacts.map(|event| ["a", "b"].map(|name| event[name].as_str().unwrap().to_owned())).collect()
}

/// Pairs that `check --motion` reports.
fn found(folder: &Folder) -> BTreeSet<[String; 2]> {
    let check = folder.val3(&["check", "--motion", "--select", "V0420,V0421", "--format", "json-lines"]);
    let findings = check.stdout.lines().filter_map(|line| serde_json::from_str::<Value>(line).ok());
    let messages = findings.filter_map(|finding| Some(finding["message"].as_str()?.to_owned()));
    let pair = |message: String| {
        let (first, second) = message.rsplit_once("` touches `").unwrap();
        let first = first.rsplit_once('`').unwrap().1;
        [first.to_owned(), second.trim_end_matches('`').to_owned()]
    };
    messages.map(pair).collect()
}

#[test]
fn every_contact_of_a_check_is_a_contact_of_a_run() {
    let mut checked = BTreeSet::new();
    for place in [150, 250, 330, 395, 460, 520, 900] {
        let folder = folder(place);
        let (found, touching) = (found(&folder), touching(&folder));
        assert!(found.is_subset(&touching), "post at {place}: {found:?} in {touching:?}");
        assert_eq!(found.is_empty(), touching.is_empty(), "post at {place}: {touching:?}");
        checked.extend(found);
    }
    assert!(checked.len() > 1, "{checked:?}");
}

#[test]
fn contacts_are_reported_on_request() {
    let folder = folder(400);
    assert_eq!(folder.val3(&["check", "--quiet"]).stdout.matches("V042").count(), 0);
    expect![[r#"
        usrapp/main/main.dtx:4:17: info[V0113] no program uses `fPost`
        usrapp/main/start.pgx:8:7: info[V0421] on the way from `pX[0]` to `pX[1]`, `link6` touches `post`
    "#]]
    .assert_eq(&folder.val3(&["check", "--motion", "--format", "concise"]).stdout);
}

#[test]
fn a_fault_of_the_cell_ends_the_check() {
    let folder = folder(400);
    folder.write("cell.toml", &CELL.replace("tGrip", "tGrp"));
    let check = folder.val3(&["check"]);
    expect![[r#"
        error: there is no frame, tool or object `tGrp`
         --> cell.toml:9
          |
        9 | in = "tGrp"
          | ^^
          help: did you mean `tGrip`?
    "#]]
    .assert_eq(&check.stderr);
    assert_eq!((check.code, check.stdout.as_str()), (2, ""));
}

#[test]
fn a_check_of_one_application_accepts_the_names_of_another_one() {
    let folder = folder(400);
    folder.write("cell.toml", &CELL.replace("tGrip", "tOther"));
    assert_eq!(folder.val3(&["check", "usrapp/main"]).code, 0);
}
