//! `val3 check --motion`: compares positions and moves with the arm.

use expect_test::expect;

use crate::support::Folder;

const CELL: &str = r#"
movej(pPick["near"],flange,mFast)
movej(jPark,flange,mFast)
movel(pBehind,flange,mFast)
waitEndMove()

=== main/main.dtx
<?xml version="1.0" encoding="utf-8"?>
<Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
  <Datas>
    <Data name="fTable" access="private" xsi:type="array" type="frame" size="1">
      <Value key="0" x="500" fatherId="world[0]" />
    </Data>
    <Data name="jPark" access="private" xsi:type="array" type="jointRx" size="1">
      <Value key="0" j3="90" j5="90" />
    </Data>
    <Data name="jOld" access="private" xsi:type="array" type="jointRx" size="1">
      <Value key="0" j5="200" />
    </Data>
    <Data name="mFast" access="private" xsi:type="array" type="mdesc" size="1" />
    <Data name="pBehind" access="private" xsi:type="array" type="pointRx" size="1">
      <Value key="0" x="-1000" z="300" rx="180" fatherId="fTable[0]" />
    </Data>
    <Data name="pPick" access="private" xsi:type="collection" type="pointRx">
      <Value key="near" z="300" rx="180" fatherId="fTable[0]" />
      <Value key="far" x="900" z="300" rx="180" fatherId="fTable[0]" />
    </Data>
  </Datas>
</Database>
"#;

fn cell() -> Folder {
    Folder::with(CELL)
}

#[test]
fn positions_and_moves_are_compared_with_the_arm_on_request() {
    let folder = cell();
    assert_eq!(folder.val3(&["check", "--quiet"]).stdout.matches("V041").count(), 0);
    let found = folder.val3(&["check", "--motion", "--format", "concise"]);
    expect![[r#"
        usrapp/main/main.dtx:10:17: info[V0113] no program uses `jOld`
        usrapp/main/main.dtx:11:19: info[V0412] the joint position `jOld` has axis 5 at 200 outside the range of the TX2-90
        usrapp/main/main.dtx:19:19: info[V0411] the point `pPick["far"]` is 557.2 mm beyond the reach of the TX2-90
        usrapp/main/start.pgx:8:7: info[V0413] the TX2-90 cannot move straight from `jPark` to `pBehind`: the centre of the wrist would be 49.6 mm from axis 1, the arm needs at least 50.0 mm
    "#]].assert_eq(&found.stdout);
    expect!["note: no arm is named: positions and moves are compared with a TX2-90; name yours with --arm, in val3.toml or in arm.cfx"].assert_eq(found.stderr.lines().next().unwrap());
    assert_eq!(found.code, 0);
    let loud = folder.val3(&["check", "--motion", "--fail-level", "info", "--quiet"]);
    assert_eq!((loud.code, loud.stderr.as_str()), (1, ""));
}

#[test]
fn the_arm_is_that_of_the_command_line_then_of_the_settings_then_of_the_cell() {
    let folder = cell();
    let names = |args: &[&str]| arm_names(&folder, args);
    assert_eq!(names(&[]), (vec!["TX2-90"], true));
    folder.write("configs/arm.cfx", "<arm><String name=\"arm\" value=\"tx200-S1\"/></arm>");
    assert_eq!(names(&[]), (vec!["TX200"], false));
    folder.write("val3.toml", "arm = \"tx2-60\"\n");
    assert_eq!(names(&[]), (vec!["TX2-60"], false));
    assert_eq!(names(&["--arm", "tx2-90"]), (vec!["TX2-90"], false));
}

/// Arms in the findings, and whether a note states that no arm is named.
fn arm_names(folder: &Folder, args: &[&str]) -> (Vec<&'static str>, bool) {
    let run = folder.val3(&[&["check", "--motion", "--format", "concise"], args].concat());
    let mut names = vec!["TX2-90", "TX2-60", "TX200"];
    names.retain(|name| run.stdout.contains(&format!("the {name}\n")));
    (names, run.stderr.contains("no arm is named"))
}

#[test]
fn settings_turn_the_comparison_on() {
    let folder = cell();
    folder.write("val3.toml", "[lint]\nmotion = true\n[rules]\nV0412 = \"warning\"\n");
    let found = folder.val3(&["check", "--format", "concise"]);
    assert!(found.stdout.contains("info[V0411]") && found.stdout.contains("warning[V0412]"), "{}", found.stdout);
    assert_eq!(folder.val3(&["check", "--ignore", "V0411,V0412,V0413", "-q"]).stdout.matches("V041").count(), 0);
    let explained = folder.val3(&["check", "--explain-config"]).stdout;
    assert!(explained.contains("val3.toml:2 (lint.motion)"), "{explained}");
}

#[test]
fn the_findings_are_in_every_format() {
    let folder = cell();
    for format in
        ["json", "json-lines", "sarif", "github", "gitlab", "azure", "junit", "checkstyle", "rdjson", "val3check"]
    {
        let found = folder.val3(&["check", "--motion", "--format", format]);
        let rule_is_shown = found.stdout.contains("V0411") || format == "val3check";
        assert!(rule_is_shown && found.stdout.contains("beyond the reach"), "{format}: {}", found.stdout);
    }
}

#[test]
fn an_arm_that_is_not_known_is_an_error() {
    let folder = cell();
    let found = folder.val3(&["check", "--motion", "--arm", "tx999"]);
    assert_eq!(found.code, 2);
    assert!(found.stderr.contains("the arm `tx999` is not known"), "{}", found.stderr);
    folder.write("val3.toml", "arm = \"my.toml\"\n");
    assert_eq!(folder.val3(&["check"]).code, 0);
    let found = folder.val3(&["check", "--motion"]);
    assert_eq!(found.code, 2);
    assert!(found.stderr.contains("the arm of `my.toml` cannot be used"), "{}", found.stderr);
    folder.write("my.toml", "name = 3\n");
    let found = folder.val3(&["check", "--motion"]);
    assert!(found.stderr.contains("line 1"), "{}", found.stderr);
}

/// The rules are off unless `--motion` turns them on.
#[test]
fn speeds_beyond_the_maximum_are_findings() {
    let code = "mdesc mFast\n  mFast.vel=200\n  movej({0,0,90,0,90,0},flange,mFast)\n  waitEndMove()\n";
    let folder = Folder::with(code);
    assert!(!folder.val3(&["check", "--quiet"]).stdout.contains("V0415"));
    let found = folder.val3(&["check", "--motion", "--arm", "TX2-60L", "--format", "concise", "--quiet"]);
    expect![[r#"
        usrapp/main/start.pgx:5:13: info[V0415] `vel` = 200 moves axis 1 of the TX2-60L faster than its maximum speed
    "#]]
    .assert_eq(&found.stdout);
}
