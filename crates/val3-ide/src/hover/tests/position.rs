//! Poses, joints and circular fathers.

use expect_test::{Expect, expect};

use crate::hover::hover;
use crate::testing::MarkedListing;

const ARM: &str = "=== /configs/arm.cfx\n<arm><String name=\"arm\" value=\"tx2_90-S1\"/></arm>\n";

/// Checks the hover lines after the declaration and its values.
fn check(code: &str, values: &str, arm: &str, expected: Expect) {
    let data = format!(
        "=== main/main.dtx\n<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<Database \
         xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" \
         xmlns=\"http://www.staubli.com/robotics/VAL3/Data/2\">\n  <Datas>\n{values}\n  </Datas>\n</Database>\n"
    );
    let marked = MarkedListing::new(&format!("{code}\n\n{data}{arm}"));
    let found = hover(marked.db(), marked.at()).map_or_else(|| "nothing".to_owned(), |hover| hover.markdown);
    let end = found.rfind("```").map_or(0, |end| end + 3);
    let rest = found[end..].trim();
    expected.assert_eq(&(if rest.is_empty() { "nothing more" } else { rest }.to_owned() + "\n"));
}

const TABLE: &str = "    <Data name=\"fTable\" access=\"private\" xsi:type=\"array\" type=\"frame\" size=\"1\">\n      \
    <Value key=\"0\" x=\"500\" rz=\"90\" fatherId=\"world[0]\"/>\n    </Data>\n    \
    <Data name=\"pPick\" access=\"private\" xsi:type=\"array\" type=\"pointRx\" size=\"3\">\n      \
    <Value key=\"0\" x=\"100\" z=\"300\" rx=\"180\" fatherId=\"fTable[0]\"/>\n      \
    <Value key=\"2\" y=\"-2000\" rx=\"180\" fatherId=\"fTable[0]\"/>\n    </Data>\n    \
    <Data name=\"jHome\" access=\"private\" xsi:type=\"array\" type=\"jointRx\" size=\"1\">\n      \
    <Value key=\"0\" j3=\"90\" j5=\"200\"/>\n    </Data>\n    \
    <Data name=\"tGrip\" access=\"private\" xsi:type=\"array\" type=\"tool\" size=\"1\">\n      \
    <Value key=\"0\" z=\"150\" fatherId=\"flange[0]\"/>\n    </Data>\n    \
    <Data name=\"mX\" access=\"private\" xsi:type=\"array\" type=\"mdesc\" size=\"1\"/>";

#[test]
fn a_frame_and_a_tool_show_their_pose() {
    check(
        "link(fTa$0ble,world)",
        TABLE,
        "",
        expect![[r#"
        father: `world`

        in `world`: x=500 y=0 z=0 mm, rx=0 ry=0 rz=90 degrees

        at the start; a program changes it or one of its fathers
    "#]],
    );
    check(
        "nX=size(tGr$0ip)",
        TABLE,
        ARM,
        expect![[r#"
        father: `flange`

        on the flange: x=0 y=0 z=150 mm, rx=0 ry=0 rz=0 degrees
    "#]],
    );
}

#[test]
fn a_frame_shows_the_joints_at_its_origin() {
    check(
        "pPick[0]=here(flange,fTa$0ble)",
        TABLE,
        ARM,
        expect![[r#"
        father: `world`

        in `world`: x=500 y=0 z=0 mm, rx=0 ry=0 rz=90 degrees

        TX2-90 with `flange`: out of reach, axis 5 would be at 159.951, its limits are -115 and 140 degrees
    "#]],
    );
}

#[test]
fn elements_show_pose_and_joints() {
    check(
        "movej(pPi$0ck[0],flange,mX)",
        TABLE,
        ARM,
        expect![[r#"
        father: `fTable`, on `world`

        in `world`: x=500 y=100 z=300 mm, rx=180 ry=0 rz=-90 degrees

        TX2-90 with `flange`: j1=5.683° j2=4.468° j3=88.73° j4=0° j5=86.802° j6=95.683°, `lefty`, `epositive`, `wpositive`
    "#]],
    );
    check(
        "movej(pPi$0ck,tGrip,mX)",
        TABLE,
        ARM,
        expect![[r#"
        father: `fTable`, on `world`

        in `world`: x=500 y=100 z=300 mm, rx=180 ry=0 rz=-90 degrees

        TX2-90 with `tGrip`: j1=5.683° j2=7.062° j3=65.378° j4=0° j5=107.56° j6=95.683°, `lefty`, `epositive`, `wpositive`
    "#]],
    );
    check(
        "movej(pPi$0ck[2],flange,mX)",
        TABLE,
        ARM,
        expect![[r#"
        father: `fTable`, on `world`

        in `world`: x=2500 y=0 z=0 mm, rx=180 ry=0 rz=-90 degrees

        TX2-90 with `flange`: out of reach, the centre of the wrist would be 2451.5 mm from the shoulder, the arm reaches 0.0 to 850.0 mm
    "#]],
    );
    check(
        "movej(pPi$0ck[0],flange,mX)",
        TABLE,
        "",
        expect![[r#"
        father: `fTable`, on `world`

        in `world`: x=500 y=100 z=300 mm, rx=180 ry=0 rz=-90 degrees
    "#]],
    );
    check(
        "movej(pPi$0ck[1],flange,mX)",
        TABLE,
        ARM,
        expect![[r#"
        father: `fTable`, on `world`
    "#]],
    );
    check(
        "num nA\nmovej(pPi$0ck[nA],flange,mX)",
        TABLE,
        ARM,
        expect![[r#"
        father: `fTable`, on `world`
    "#]],
    );
}

#[test]
fn a_changed_point_says_so() {
    check(
        "pPi$0ck[0]=here(flange,fTable)",
        TABLE,
        "",
        expect![[r#"
        father: `fTable`, on `world`

        in `world`: x=500 y=100 z=300 mm, rx=180 ry=0 rz=-90 degrees

        at the start; a program changes it or one of its fathers
    "#]],
    );
}

#[test]
fn joints_show_the_flange() {
    check(
        "movej(jHo$0me,flange,mX)",
        TABLE,
        ARM,
        expect![[r#"
        TX2-90: flange in `world` x=381.031 y=50 z=459.202 mm, rx=0 ry=-70 rz=0 degrees

        axis 5 is outside its range from -115 to 140 degrees
    "#]],
    );
    check("movej(jHo$0me,flange,mX)", TABLE, "", expect![["nothing more\n"]]);
}

#[test]
fn values_in_data_files_show_their_pose() {
    check(
        "putln(1)",
        &TABLE.replace("y=\"-2000\"", "y=\"-20$000\""),
        ARM,
        expect![[r#"
        Translation along y. (mm)

        in `world`: x=2500 y=0 z=0 mm, rx=180 ry=0 rz=-90 degrees

        TX2-90 with `flange`: out of reach, the centre of the wrist would be 2451.5 mm from the shoulder, the arm reaches 0.0 to 850.0 mm
    "#]],
    );
    check(
        "putln(1)",
        &TABLE.replace("<Value key=\"0\" x=\"500\"", "<Value ke$0y=\"0\" x=\"500\""),
        "",
        expect![[r#"
        Index in an array (`2`, or `2,1` with two dimensions), or key in a collection.

        required

        in `world`: x=500 y=0 z=0 mm, rx=0 ry=0 rz=90 degrees
    "#]],
    );
}

#[test]
fn fields_of_user_types_show_their_pose() {
    let slots = "    <Data name=\"tSlots\" access=\"private\" xsi:type=\"array\" type=\"Slot\" size=\"1 2\">\n      \
        <Value key=\"0,1\">\n<Field name=\"pPlace\" xsi:type=\"array\" type=\"pointRx\" size=\"1\">\n\
        <Value key=\"0\" x=\"600\" z=\"200\" rx=\"180\" fatherId=\"world[0]\"/></Field></Value>\n    </Data>";
    let code = "movej(tSlots[0,1].pPl$0ace,flange,mX)";
    check(
        &format!(
            "type Slot \"Disk://Slot/Slot.pjx\"\nSlot tSlots[1,2]\nmdesc mX\n{code}\n\n--- Slot\npublic point pPlace\n\n--- main"
        ),
        slots,
        ARM,
        expect![[r#"
        father: `world`

        in `world`: x=600 y=0 z=200 mm, rx=180 ry=0 rz=0 degrees

        TX2-90 with `flange`: j1=-4.78° j2=18.597° j3=85.402° j4=0° j5=76.001° j6=175.22°, `lefty`, `epositive`, `wpositive`
    "#]],
    );
}

#[test]
fn a_loop_of_fathers_is_shown() {
    let values = "    <Data name=\"fA\" access=\"private\" xsi:type=\"array\" type=\"frame\" size=\"1\">\n\
        <Value key=\"0\" x=\"5\" fatherId=\"fB[0]\"/></Data>\n    \
        <Data name=\"fB\" access=\"private\" xsi:type=\"array\" type=\"frame\" size=\"1\">\n\
        <Value key=\"0\" fatherId=\"fA[0]\"/></Data>\n    \
        <Data name=\"fC\" access=\"private\" xsi:type=\"array\" type=\"frame\" size=\"1\">\n\
        <Value key=\"0\" fatherId=\"fA[0]\"/></Data>\n    \
        <Data name=\"fD\" access=\"private\" xsi:type=\"array\" type=\"frame\" size=\"1\">\n\
        <Value key=\"0\" x=\"1\"/></Data>";
    check(
        "link(f$0C,world)",
        values,
        "",
        expect![[r#"
        father: `fA`, on `fB`

        its placement is unknown: the fathers form a loop, `fA` on `fB` on `fA`
    "#]],
    );
    check(
        "link(f$0D,world)",
        values,
        "",
        expect![[r#"
        its placement is unknown: `fD` has no father
    "#]],
    );
}
