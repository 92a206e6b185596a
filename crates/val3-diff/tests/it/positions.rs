//! Points, frames and tools: how far they moved, and what moved with them.

use expect_test::expect;
use val3_diff::Class;

use crate::support::{check, compared, human};

fn data(values: &str) -> String {
    format!(
        "cls()\n=== main/main.dtx\n<Database xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" \
         xmlns=\"http://www.staubli.com/robotics/VAL3/Data/2\"><Datas>{values}</Datas></Database>"
    )
}

fn value(ty: &str, name: &str, values: &[&str]) -> String {
    let size = values.len();
    let values: String =
        values.iter().enumerate().map(|(key, value)| format!("<Value key=\"{key}\" {value}/>")).collect();
    format!("<Data name=\"{name}\" access=\"private\" xsi:type=\"array\" type=\"{ty}\" size=\"{size}\">{values}</Data>")
}

/// A table on `world`, a tray on the table, points in the tray and one on `world`.
fn cell(table: &str, tray: &str) -> String {
    data(
        &[
            value("frame", "fTable", &[table]),
            value("frame", "fTray", &[tray]),
            value("pointRx", "pPick", &["x=\"100\" fatherId=\"fTray[0]\"", "x=\"200\" fatherId=\"fTray[0]\""]),
            value("pointRx", "pHome", &["x=\"100\" fatherId=\"world[0]\""]),
        ]
        .concat(),
    )
}

#[test]
fn a_moved_frame_names_its_points() {
    let old = cell("x=\"500\" fatherId=\"world[0]\"", "y=\"10\" fatherId=\"fTable[0]\"");
    let new = cell("x=\"512.5\" fatherId=\"world[0]\"", "y=\"10\" fatherId=\"fTable[0]\"");
    check(
        &old,
        &new,
        &expect![[r#"
    "#]],
    );
}

#[test]
fn a_turned_frame_moves_distant_points_further() {
    let old = cell("fatherId=\"world[0]\"", "fatherId=\"fTable[0]\"");
    let new = cell("rz=\"1\" fatherId=\"world[0]\"", "z=\"2\" fatherId=\"fTable[0]\"");
    check(
        &old,
        &new,
        &expect![[r#"
    "#]],
    );
}

#[test]
fn a_moved_tool_moves_the_tools_on_it() {
    let tools = |z: &str| {
        data(
            &[
                value("tool", "tFlange", &[&format!("z=\"{z}\" fatherId=\"flange[0]\"")]),
                value("tool", "tGrip", &["z=\"100\" fatherId=\"tFlange[0]\" ioLink=\"valve1\" ioOpen=\"0.2\""]),
            ]
            .concat(),
        )
    };
    check(
        &tools("10"),
        &tools("11"),
        &expect![[r#"
    "#]],
    );
}

#[test]
fn another_father_or_configuration_is_named() {
    let point = |attributes: &str| {
        data(
            &[
                value("frame", "fA", &["x=\"10\" fatherId=\"world[0]\""]),
                value("pointRx", "pA", &[&format!("{attributes} fatherId=\"world[0]\" shoulder=\"lefty\"")]),
                value("pointRx", "pB", &[&attributes.replace("x=\"5\"", "x=\"5\" fatherId=\"fA[0]\"")]),
                value("jointRx", "jA", &["j1=\"10\""]),
                value("trsf", "trA", &[attributes]),
            ]
            .concat(),
        )
    };
    let old = point("x=\"5\"");
    let new = old
        .replace("shoulder=\"lefty\"", "shoulder=\"righty\"")
        .replace("x=\"5\" fatherId=\"fA[0]\"", "x=\"15\" fatherId=\"world[0]\"")
        .replace("j1=\"10\"", "j1=\"12.5\" j3=\"-1\"")
        .replace("x=\"5\"/>", "rz=\"0.0001\" x=\"5\"/>");
    check(
        &old,
        &new,
        &expect![[r#"
    "#]],
    );
}

#[test]
fn the_same_place_in_other_angles_is_named_as_such() {
    let point = |rz: &str| data(&value("pointRx", "pA", &[&format!("x=\"1\" rz=\"{rz}\" fatherId=\"world[0]\"")]));
    check(
        &point("180"),
        &point("-180"),
        &expect![[r#"
    "#]],
    );
}

#[test]
fn inches_are_shown_in_millimetres() {
    let project = "\n=== main/main.pjx\n<Project xmlns=\"http://www.staubli.com/robotics/VAL3/Project/3\"><Parameters \
        version=\"s7.11\" stackSize=\"5000\" millimeterUnit=\"false\"/><Programs><Program file=\"start.pgx\"/></Programs><Database>\
        <Data file=\"main.dtx\"/></Database><Libraries/><Types/></Project>";
    let old = cell("fatherId=\"world[0]\"", "fatherId=\"world[0]\"") + project;
    let new = cell("fatherId=\"world[0]\"", "x=\"1\" fatherId=\"world[0]\"") + project;
    check(
        &old,
        &new,
        &expect![[r#"
    "#]],
    );
}

#[test]
fn loops_of_fathers_are_reported_and_end() {
    let old = cell("fatherId=\"world[0]\"", "fatherId=\"fTable[0]\"");
    let new = cell("fatherId=\"fTray[0]\"", "fatherId=\"fTable[0]\"");
    check(
        &old,
        &new,
        &expect![[r#"
    "#]],
    );
}

#[test]
fn positions_can_be_asked_for_alone() {
    let old = cell("x=\"1\" fatherId=\"world[0]\"", "fatherId=\"fTable[0]\"");
    let new = cell("x=\"2\" fatherId=\"world[0]\"", "fatherId=\"fTable[0]\"").replace("cls()", "put(1)");
    let mut comparison = compared(&old, &new);
    comparison.keep(&[Class::Points]);
    let report = human(&comparison);
    assert!(report.contains("fTable") && !report.contains("Programs"), "{report}");
    comparison.keep(&[Class::Io]);
    assert!(comparison.is_empty(), "{comparison:?}");
}
