//! Points, frames and tools: their movements and their dependents.

use expect_test::expect;
use val3_diff::ReportClass;

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

/// Returns a table on `world`, a tray on the table, points in the tray and one point on `world`.
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
            main  main/main.pjx
              Points, frames and tools
                  Position      Moved  Turned   In world  Values
                ~ fTable    12.500 mm          12.500 mm  x 500 → 512.5
                ~ fTable  3 positions move with it
                    fTray  12.500 mm
                    pPick[0–1]  12.500 mm

            1 application differs: 1 position, 3 positions that moved along
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
            main  main/main.pjx
              Points, frames and tools
                  Position     Moved  Turned          In world  Values
                ~ fTray     2.000 mm          2.000 mm, 1.000°  z 0 → 2
                ~ fTable              1.000°            1.000°  rz 0 → 1
                ~ fTray  2 positions move with it
                    pPick[0–1]  2.654 to 4.023 mm, 1.000°
                ~ fTable  1 position moves with it
                    fTray  2.000 mm, 1.000°

            1 application differs: 2 positions, 3 positions that moved along
        "#]],
    );
}

fn tools(z: &str) -> String {
    data(
        &[
            value("tool", "tFlange", &[&format!("z=\"{z}\" fatherId=\"flange[0]\"")]),
            value("tool", "tGrip", &["z=\"100\" fatherId=\"tFlange[0]\" ioLink=\"valve1\" ioOpen=\"0.2\""]),
        ]
        .concat(),
    )
}

#[test]
fn a_moved_tool_moves_the_tools_on_it() {
    check(
        &tools("10"),
        &tools("11"),
        &expect![[r#"
            main  main/main.pjx
              Points, frames and tools
                  Position     Moved  Turned  On flange  Values
                ~ tFlange   1.000 mm           1.000 mm  z 10 → 11
                ~ tFlange  1 position moves with it
                    tGrip  1.000 mm

            1 application differs: 1 position, 1 position that moved along
        "#]],
    );
}

fn positions(attributes: &str) -> String {
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
}

#[test]
fn another_father_or_configuration_is_named() {
    let old = positions("x=\"5\"");
    let new = old
        .replace("shoulder=\"lefty\"", "shoulder=\"righty\"")
        .replace("x=\"5\" fatherId=\"fA[0]\"", "x=\"15\" fatherId=\"world[0]\"")
        .replace("j1=\"10\"", "j1=\"12.5\" j3=\"-1\"")
        .replace("x=\"5\"/>", "rz=\"0.0001\" x=\"5\"/>");
    check(
        &old,
        &new,
        &expect![[r#"
            main  main/main.pjx
              Points, frames and tools
                  Position         Moved   Turned    In world  Values
                ~ trA                     <0.001°              rz 0 → 0.0001
                ~ pB        other father           same place  x 5 → 15, father fA → world
                ~ jA  j1 10 → 12.5, j3 0 → -1
                ~ pA  config.shoulder lefty → righty

            1 application differs: 4 positions
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
            main  main/main.pjx
              Points, frames and tools
                  Position       Moved  Turned    In world  Values
                ~ pA        same place          same place  rz 180 → -180

            1 application differs: 1 position
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
            main  main/main.pjx
              Points, frames and tools
                  Position      Moved  Turned   In world  Values
                ~ fTray     25.400 mm          25.400 mm  x 0 → 1
                ~ fTray  2 positions move with it
                    pPick[0–1]  25.400 mm

            1 application differs: 1 position, 2 positions that moved along
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
            main  main/main.pjx
              Points, frames and tools
                  Position         Moved  Turned  In world  Values
                ~ fTable    other father                    father world → fTray
                ~ fTable  3 positions move with it
                    fTray  movement unknown, because the fathers do not lead to `world` or the flange
                    pPick[0–1]  movement unknown, because the fathers do not lead to `world` or the flange

            Notes
                ! main/main.pjx  in the new version the fathers fTable → fTray → fTable form a loop, so movements in `world` are unknown; link one of them to another frame

            1 application differs: 1 position, 3 positions that moved along
        "#]],
    );
}

#[test]
fn positions_can_be_asked_for_alone() {
    let old = cell("x=\"1\" fatherId=\"world[0]\"", "fatherId=\"fTable[0]\"");
    let new = cell("x=\"2\" fatherId=\"world[0]\"", "fatherId=\"fTable[0]\"").replace("cls()", "put(1)");
    let mut comparison = compared(&old, &new);
    comparison.keep(&[ReportClass::Points]);
    let report = human(&comparison);
    assert!(report.contains("fTable") && !report.contains("Programs"), "{report}");
    comparison.keep(&[ReportClass::Io]);
    assert!(comparison.is_empty(), "{comparison:?}");
}
