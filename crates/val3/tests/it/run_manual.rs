//! Tool speed in manual mode.

use expect_test::expect;

use crate::support::Folder;

/// A move of axis 1 and a line, with a tool of 200 mm.
const MOVES: &str = "mdesc mStop\njoint jReady\npoint pNear\ntool tLong\n  mStop.blend=off\n  tLong.trsf.z=200\n  \
                     wait(isPowered())\n  jReady={90,0,90,0,90,0}\n  movej(jReady,tLong,mStop)\n  waitEndMove()\n  \
                     pNear=here(tLong,world)\n  pNear.trsf.x=pNear.trsf.x+200\n  movel(pNear,tLong,mStop)\n  \
                     waitEndMove()\n";

/// Operator script that enables motion in a mode.
fn operator(mode: &str) -> String {
    format!("[[at]]\nt = 0\nmode = \"{mode}\"\n\n[[at]]\nt = 1\npower = true\nmove = true\n")
}

/// Rows of a trace: time, joint 1, position and speed of the tool centre point.
fn trace(folder: &Folder, mode: &str) -> Vec<[f64; 6]> {
    folder.write("operator.toml", &operator(mode));
    let run = folder.val3(&[
        "run",
        "--arm",
        "TX2-90",
        "--start",
        "0,0,90,0,90,0",
        "--script",
        "operator.toml",
        "--trace",
        "t.csv",
    ]);
    assert_eq!(run.code, 0, "{run:?}");
    let number = |row: &[&str], column: usize| row[column].parse::<f64>().unwrap();
    let rows = folder.read("t.csv");
    let rows = rows.lines().skip(1).map(|line| line.split(',').collect::<Vec<_>>());
    rows.map(|row| [0, 3, 9, 10, 11, 15].map(|column| number(&row, column))).collect()
}

fn fastest(rows: &[[f64; 6]]) -> f64 {
    rows.iter().map(|row| row[5]).fold(0.0, f64::max)
}

#[test]
fn the_tool_keeps_250_mm_per_second_in_manual_mode_on_the_same_path() {
    let folder = Folder::with(MOVES);
    let (full, manual) = (trace(&folder, "local"), trace(&folder, "manual"));
    assert!(fastest(&full) > 1500.0 && fastest(&trace(&folder, "test")) > 1500.0);
    assert!((249.0..=250.001).contains(&fastest(&manual)), "{}", fastest(&manual));
    assert!(full.last().unwrap()[2..5] == manual.last().unwrap()[2..5] && manual.len() > 3 * full.len());
    // The first move is a circle around axis 1, and the line is straight.
    let (turn, line) = manual.split_at(manual.iter().position(|row| row[1] == 90.0).unwrap());
    let radius = |[x, y, _]: [f64; 3]| x.hypot(y);
    let place = |row: &[f64; 6]| [row[2], row[3], row[4]];
    assert!(turn.iter().all(|row| (radius(place(row)) - radius(place(&turn[0]))).abs() < 1e-5));
    assert!(line.iter().all(|row| (row[3] - line[0][3]).abs() < 1e-5 && (row[4] - line[0][4]).abs() < 1e-5));
}

#[test]
fn the_cell_sets_the_speed_of_the_manual_mode() {
    let folder = Folder::with(MOVES);
    set_speed_of_cell(&folder, "100");
    assert!((99.0..=100.001).contains(&fastest(&trace(&folder, "manual"))));
    assert!(fastest(&trace(&folder, "local")) > 1500.0);
    set_speed_of_cell(&folder, "-1");
    let run = folder.val3(&[
        "run",
        "--arm",
        "TX2-90",
        "--script",
        "operator.toml",
        "--until",
        "1",
        "--until-ok",
        "--events",
        "-",
    ]);
    let warnings: Vec<_> = run.stdout.lines().filter(|line| line.contains("maxManuCartSpeed")).collect();
    expect![[r#"
        {"t":0.0,"kind":"log","level":"warning","text":"cell.cfx: maxManuCartSpeed is `-1`, not a speed above 0 in mm/s; it is not used"}
    "#]]
    .assert_eq(&(warnings.join("\n") + "\n"));
}

fn set_speed_of_cell(folder: &Folder, speed: &str) {
    folder.write("configs/cell.cfx", &format!("<cell><Float name=\"maxManuCartSpeed\" value=\"{speed}\"/></cell>"));
}

/// A change of the mode cuts the power. If it is restored immediately, the arm brakes and continues slowly.
#[test]
fn a_change_to_manual_mode_slows_a_moving_arm() {
    let folder = Folder::with(MOVES);
    let script = "[[at]]\nt = 0\npower = true\n\n[[at]]\nt = 0.2\nmode = \"manual\"\npower = true\nmove = true\n";
    folder.write("change.toml", script);
    let run = folder.val3(&[
        "run",
        "--arm",
        "TX2-90",
        "--start",
        "0,0,90,0,90,0",
        "--script",
        "change.toml",
        "--trace",
        "t.csv",
    ]);
    assert_eq!(run.code, 0, "{run:?}");
    let text = folder.read("t.csv");
    let column = text.lines().next().unwrap().split(',').position(|name| name == "v").unwrap();
    let speed = |row: &&str| row.split(',').nth(column).unwrap().parse::<f64>().unwrap();
    let rows: Vec<_> = text.lines().skip(1).collect();
    let fastest = rows.iter().map(speed).fold(0.0, f64::max);
    assert!(fastest > 1000.0, "{fastest}");
    let rest = rows.iter().rposition(|row| row.contains(",stopping,")).unwrap();
    let slow = rows[rest + 1..].iter().map(speed).fold(0.0, f64::max);
    assert!((249.0..=250.001).contains(&slow), "{slow}");
    assert!(rows.windows(2).all(|pair| (speed(&pair[1]) - speed(&pair[0])).abs() < 60.0), "no jump of the speed");
}
