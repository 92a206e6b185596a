use expect_test::{Expect, expect};

use super::*;
use crate::testing::MarkedListing;

const DATA: &str = r#"
movej(pPick[0],tGrip,mX)
link(fMoved,world)
=== main/main.dtx
<Database>
  <Datas>$0
    <Data name="fTable" access="private" xsi:type="array" type="frame" size="1">
      <Value key="0" x="500" rz="90" fatherId="world[0]" />
    </Data>
    <Data name="fMoved" access="private" xsi:type="array" type="frame" size="1">
      <Value key="0" x="500" />
    </Data>
    <Data name="pPick" access="private" xsi:type="array" type="pointRx" size="4">
      <Value key="0" x="100" z="300" rx="180" fatherId="fTable[0]" />
      <Value key="1" fatherId="fTable[0]" />
      <Value key="2" y="-2000" rx="180" fatherId="fTable[0]" />
    </Data>
    <Data name="jHome" access="private" xsi:type="array" type="jointRx" size="2">
      <Value key="0" j3="90" />
      <Value key="1" j5="200" />
    </Data>
    <Data name="tGrip" access="private" xsi:type="array" type="tool" size="1">
      <Value key="0" z="150" fatherId="flange[0]" />
    </Data>
    <Data name="mX" access="private" xsi:type="array" type="mdesc" size="1" />
  </Datas>
</Database>
"#;

const ARM: &str = "=== /configs/arm.cfx\n<arm><String name=\"arm\" value=\"tx2_90-S1\"/></arm>\n";

fn check(arm: &str, names: &[&str], expected: Expect) {
    let marked = MarkedListing::new(&format!("{DATA}{arm}"));
    let file = marked.at().file;
    let project = crate::owner(marked.db(), file).unwrap();
    let names: Vec<String> = names.iter().map(|name| (*name).to_owned()).collect();
    let shown: String = data_poses(marked.db(), project, file, &names).into_iter().map(line).collect();
    expected.assert_eq(&shown);
}

fn line(found: DataPose) -> String {
    let key = found.place.key.unwrap();
    let (name, chain) = (found.place.name, found.chain.join(" on "));
    let (pose, joints, reached) = (found.pose, found.joints, found.reach);
    format!("{name}[{key}] {pose:?} {chain:?} {reached:?} {joints:?} {:?}\n", found.remark)
}

#[test]
fn points_have_a_place_and_joints() {
    check(
        ARM,
        &["pPick"],
        expect![[r#"
        pPick[0] Some([500.0, 100.0, 300.0, 180.0, 0.0, -90.0]) "pPick on fTable" Some(Reachable) Some([5.683, 7.062, 65.378, 0.0, 107.56, 95.683]) Some("TX2-90 with `tGrip`")
        pPick[1] Some([500.0, 0.0, 0.0, 0.0, 0.0, 90.0]) "pPick[1] on fTable" None None Some("all values are 0: it has not been taught")
        pPick[2] Some([2500.0, 0.0, 0.0, 180.0, 0.0, -90.0]) "pPick[2] on fTable" Some(OutOfReach) None Some("TX2-90 with `tGrip`: the centre of the wrist would be 2462.2 mm from the shoulder, the arm reaches 0.0 to 850.0 mm")
    "#]],
    );
    check(
        "",
        &["pPick"],
        expect![[r#"
        pPick[0] Some([500.0, 100.0, 300.0, 180.0, 0.0, -90.0]) "pPick on fTable" Some(NoArm) None Some("no arm is named: name yours in val3.toml (`arm`) or in arm.cfx")
        pPick[1] Some([500.0, 0.0, 0.0, 0.0, 0.0, 90.0]) "pPick[1] on fTable" Some(NoArm) None Some("no arm is named: name yours in val3.toml (`arm`) or in arm.cfx")
        pPick[2] Some([2500.0, 0.0, 0.0, 180.0, 0.0, -90.0]) "pPick[2] on fTable" Some(NoArm) None Some("no arm is named: name yours in val3.toml (`arm`) or in arm.cfx")
    "#]],
    );
}

#[test]
fn joints_without_an_arm_have_the_reason() {
    check(
        "",
        &["jHome", "tGrip"],
        expect![[r#"
        jHome[0] None "" Some(NoArm) None Some("no arm is named: name yours in val3.toml (`arm`) or in arm.cfx")
        jHome[1] None "" Some(NoArm) None Some("no arm is named: name yours in val3.toml (`arm`) or in arm.cfx")
        tGrip[0] Some([0.0, 0.0, 150.0, 0.0, 0.0, 0.0]) "tGrip" None None None
    "#]],
    );
}

#[test]
fn frames_tools_and_joints_have_places() {
    check(
        ARM,
        &["fTable", "tGrip", "jHome", "mX"],
        expect![[r#"
        fTable[0] Some([500.0, 0.0, 0.0, 0.0, 0.0, 90.0]) "fTable" Some(OutOfReach) None Some("TX2-90 with `flange`: axis 5 would be at 159.951, its limits are -115 and 140 degrees")
        jHome[0] Some([575.0, 50.0, 425.0, 0.0, 90.0, 0.0]) "" Some(Reachable) Some([0.0, 0.0, 90.0, 0.0, 0.0, 0.0]) None
        jHome[1] Some([15.798, 50.0, 756.031, 0.0, -160.0, 0.0]) "" Some(OutOfReach) Some([0.0, 0.0, 0.0, 0.0, 200.0, 0.0]) Some("axis 5 is outside its range from -115 to 140 degrees")
        tGrip[0] Some([0.0, 0.0, 150.0, 0.0, 0.0, 0.0]) "tGrip" None None None
    "#]],
    );
    check(
        ARM,
        &["fMoved"],
        expect![[r#"
        fMoved[0] None "" None None Some("its placement is unknown: `fMoved` has no father")
    "#]],
    );
}

#[test]
fn paths_are_places() {
    let place = place_of_path("tSlots[1,2].pPlace[0]");
    assert_eq!((place.name.as_str(), place.key.as_deref()), ("tSlots", Some("1,2")));
    assert_eq!(place.within[0].name, "pPlace");
    assert_eq!(place_of_path("pA[a.b]").key.as_deref(), Some("a.b"));
}
