//! Expectations about the motion of the arm.

use expect_test::{Expect, expect};
use val3_suite::{Judgement, RecordedMotion};

use crate::bench::Bench;

/// A move of 100 mm along the axis y, in a straight line.
const CODE: &str = "\
joint jReady
point pEnd
mdesc mLine
frame fTable
program start()
begin
  fTable.trsf.y=50
  link(fTable,world)
  link(pEnd,world)
  mLine.blend=off
  mLine.vel=100
  enablePower()
  wait(isPowered())
  jReady={0,0,90,0,90,0}
  movej(jReady,flange,mLine)
  waitEndMove()
  pEnd=here(flange,world)
  pEnd.trsf.y=pEnd.trsf.y+100
  movel(pEnd,flange,mLine)
  waitEndMove()
end
";

#[track_caller]
fn check(expectations: &str, expected: Expect) {
    let mut bench = Bench::open(CODE, "main");
    let result = bench.scenario(expectations);
    expected.assert_eq(&bench.shown(&result));
}

#[test]
fn speeds_and_boxes_are_limited() {
    check("[[expect.speed]]\nbelow = 4000\n", expect!["ok, 1.688 s"]);
    check(
        "[[expect.speed]]\nbelow = 20\n",
        expect![[r#"
        failed, 1.688 s
        the tool centre point moves at 3319.5 mm/s instead of at most 20 mm/s, at 1.208 s at (371.0, 50.0, 823.8), in move 0 (movej, start:13)
          at start (main/start.pgx:13)
          at expect.speed (cell.toml:1)"#]],
    );
    let beyond = "box = { min = [5000, -20, 0], max = [6000, 200, 800] }";
    check(&format!("[[expect.speed]]\nbelow = 20\n{beyond}\n"), expect!["ok, 1.688 s"]);
    check(
        &format!("[[expect.inside]]\n{beyond}\n"),
        expect![[r#"
        failed, 1.688 s
        the tool centre point is 4952.135 mm outside of its box, at 1.008 s at (50.1, 50.0, 950.0), in move 0 (movej, start:13)
          at start (main/start.pgx:13)
          at expect.inside (cell.toml:1)"#]],
    );
    check(&format!("[[expect.clear]]\ndistance = 5\n{beyond}\n"), expect!["ok, 1.688 s"]);
    let around = "box = { min = [400, 100, 0], max = [600, 1000, 1000] }";
    check(
        &format!("[[expect.clear]]\ndistance = 5\n{around}\n"),
        expect![[r#"
        failed, 1.688 s
        the tool centre point is in the box to which it must keep a distance of 5 mm, at 1.588 s at (475.0, 100.0, 325.0), in move 1 (movel, start:17)
          at start (main/start.pgx:17)
          at expect.clear (cell.toml:1)"#]],
    );
}

#[test]
fn a_box_is_relative_to_its_frame() {
    let expectation = |y: f64, frame: &str| {
        format!(
            "[[expect.inside]]\nbox = {{ min = [-5000, {y}, -5000], max = [5000, 5000, 5000], frame = \"{frame}\" }}\n"
        )
    };
    check(&expectation(-1.0, "fTable"), expect!["ok, 1.688 s"]);
    check(
        &expectation(1.0, "fTable"),
        expect![[r#"
        failed, 1.688 s
        the tool centre point is 1.000 mm outside of its box, at 1.008 s at (50.1, 50.0, 950.0), in move 0 (movej, start:13)
          at start (main/start.pgx:13)
          at expect.inside (cell.toml:1)"#]],
    );
    check(
        &expectation(-1.0, "fNone"),
        expect![[r#"
        failed, 1.688 s
        the box has no place: there is no frame `fNone` in the application, or it has no reference
          at expect.inside (cell.toml:1)"#]],
    );
}

#[test]
fn an_arm_at_rest_meets_no_expectation_about_motion() {
    let mut bench = Bench::open("? \"on\"", "main");
    let mut shown = |expectations: &str| {
        let result = bench.scenario(expectations);
        (bench.shown(&result), result.motion)
    };
    let speed = shown("[expect]\nspeed = [{ below = 250 }]\n").0;
    expect![[r#"
        failed, 0.004 s
        the arm has not moved (`power = true` in a script gives it power), so no speed was compared
          at expect.speed (cell.toml:2)"#]]
    .assert_eq(&speed);
    let inside = shown("[expect]\ninside = [{ box = { min = [-1, -1, -1], max = [1, 1, 1] } }]\n").0;
    expect![[r#"
        failed, 0.004 s
        the tool centre point is 951.527 mm outside of its box, at 0.004 s at (50.0, 50.0, 950.0), in move -1
          at expect.inside (cell.toml:2)"#]]
    .assert_eq(&inside);
    let (_, motion) = shown("[expect]\ntrace = \"day.csv\"\n");
    let failure = motion.unwrap().at_rest().unwrap();
    assert!(failure.message.ends_with("so there is nothing to compare with `day.csv`"), "{failure:?}");
}

/// Returns the motion of the program with another text in place of one.
fn motion(from: &str, to: &str) -> RecordedMotion {
    assert!(CODE.contains(from), "{from}");
    let mut bench = Bench::open(&CODE.replace(from, to), "main");
    *bench.scenario("[expect]\ntrace = { file = \"day.csv\", mm = 0.5 }\n").motion.unwrap()
}

#[test]
fn a_recorded_motion_is_compared() {
    let recorded = motion("y+100", "y+100");
    assert_eq!((recorded.file(), recorded.at_rest()), ("day.csv", None));
    let text = recorded.text();
    assert_eq!(recorded.judge(&text), Judgement::default());
    assert_eq!(motion("y+100", "y+100.4").judge(&text), Judgement::default());
    let Judgement { failure, picture } = motion("y+100", "y+101").judge(&text);
    let failure = failure.unwrap();
    expect![[r#"
        the motion is not that of `day.csv`
        move 1 (movel, start:17) leaves the recorded path: 1.000 mm away, at 1.684 s at (475.0, 151.0, 325.0); this is the largest deviation"#]].assert_eq(&failure.message);
    let places: Vec<_> = failure.places.iter().map(|place| (place.program.as_str(), place.line)).collect();
    assert_eq!(places, [("start", 17), ("expect.trace", 2)]);
    assert!(picture.unwrap().starts_with("<svg"));
}

/// Returns a trace without some of its columns and without the name of its arm.
fn without_columns(trace: &str, names: &[&str]) -> String {
    let rows: Vec<Vec<&str>> =
        trace.lines().filter(|line| !line.starts_with('#')).map(|line| line.split(',').collect()).collect();
    let is_kept = |column: usize| !names.contains(&rows[0][column]);
    let kept = |row: &Vec<&str>| {
        let cells: Vec<&str> =
            row.iter().zip(0..).filter(|(_, column)| is_kept(*column)).map(|(cell, _)| *cell).collect();
        cells.join(",") + "\n"
    };
    rows.iter().map(kept).collect()
}

#[test]
fn a_file_that_cannot_be_compared_is_a_failure() {
    let motion = motion("y+100", "y+100");
    let messages = [
        motion.missing(),
        motion.refused("no permission"),
        motion.judge("text").failure.unwrap(),
        motion.judge(&without_columns(&motion.text(), &["j5", "j6"])).failure.unwrap(),
        motion.judge(&motion.text().replace("TX2-90", "TX2-60")).failure.unwrap(),
    ];
    let messages: String = messages.map(|failure| failure.message + "\n").concat();
    expect![[r#"
        there is no recorded motion `day.csv`: `val3 test --update` records this motion
        the recorded motion `day.csv` cannot be read: no permission
        the recorded motion `day.csv` cannot be read: line 1: a trace begins with the names of its columns, as in `t,id,phase,j1,j2,j3,j4,j5,j6,x,y,z,rx,ry,rz,v`: `text` are others; `val3 test --update` records this motion
        `day.csv` was recorded with a arm with 4 axes, and this arm is a TX2-90: choose the arm with --arm or in val3.toml; `val3 test --update` records this motion
        `day.csv` was recorded with a TX2-60, and this arm is a TX2-90: choose the arm with --arm or in val3.toml; `val3 test --update` records this motion
    "#]].assert_eq(&messages);
}

/// The note appears only if a limit was compared with motion times.
#[test]
fn limits_of_times_of_a_model_arm_are_noted() {
    let note = |code: &str, expectations: &str| Bench::open(code, "main").scenario(expectations).times_note;
    let limit = "[[expect.time]]\nbelow = 10\n";
    assert!(note(CODE, limit).unwrap().starts_with("times of a model arm: "));
    assert_eq!((note("delay(1)", limit), note(CODE, "")), (None, None));
}

#[test]
fn starts_of_moves_are_occurrences() {
    check("[[expect.order]]\nevents = [{ move = \"start\" }, { move = \"start\" }]\n", expect!["ok, 1.688 s"]);
}

#[test]
fn a_cycle_lasts_from_each_start_of_an_occurrence_to_the_next_one() {
    let code = "program start()\nbegin\n  ? \"go\"\n  delay(1)\n  ? \"go\"\n  delay(2)\n  ? \"go\"\n  delay(9)\nend\n";
    let mut bench = Bench::open(code, "main");
    let mut outcome = |below: f64| {
        let result = bench.scenario(&format!("[[expect.time]]\nbelow = {below}\ncycle = {{ print = \"go\" }}\n"));
        bench.shown(&result)
    };
    expect!["ok, 12.004 s"].assert_eq(&outcome(2.1));
    expect![[r#"
        failed, 12.004 s
        the cycle takes 2.000 s instead of at most 1.5 s, from 1.000 s to 3.000 s
          at expect.time (cell.toml:1)"#]]
    .assert_eq(&outcome(1.5));
}

#[test]
fn a_move_is_found_by_its_line() {
    let of_line = |line: u32| format!("[[expect.order]]\nevents = [{{ move = \"start:{line}\" }}]\n");
    check(&of_line(17), expect!["ok, 1.688 s"]);
    check(
        &of_line(14),
        expect![[r#"
            failed, 1.688 s
            not in this order until the end at 1.688 s:
                missing  a move of `start` in line 14 starts
              at expect.order (cell.toml:2)"#]],
    );
}
