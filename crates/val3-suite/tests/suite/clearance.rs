//! Expectations about the distances of things around the arm.

use expect_test::{Expect, expect};
use val3_suite::Scenario;
use val3_test::Fixture;

use crate::bench::Bench;

/// A move of 100 mm along the axis y in a straight line, with a rod at the flange and a wall 40 mm behind its end.
const CODE: &str = "\
joint jReady
point pEnd
mdesc mLine
program start()
begin
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
=== main/cell.toml
[[object]]
name = \"rod\"
in = \"flange\"
capsule = { from = [0, 0, 0], to = [0, 0, 60], radius = 10 }

[[object]]
name = \"wall\"
box = { min = [300, WALL, -1000], max = [2000, 999, 320] }
";

/// Executes a scenario with the wall at this y coordinate.
#[track_caller]
fn check(wall: f64, expectations: &str, expected: Expect) {
    let mut bench = Bench::open(&CODE.replace("WALL", &wall.to_string()), "main");
    let result = bench.scenario(expectations);
    expected.assert_eq(&bench.shown(&result));
}

#[track_caller]
fn faults(code: &str, expectations: &str, expected: Expect) {
    let bench = Bench::open(code, "main");
    let scenario = Scenario::parse("test.toml", expectations).unwrap();
    expected.assert_eq(&bench.faults(&scenario).join("\n"));
}

#[test]
fn distances_have_limits() {
    check(
        200.0,
        "[expect]\nclearance = 30\n",
        expect![[r#"
        failed, 1.688 s
        `link6` is 8.5 mm from `wall` at 1.684 s; at least 30 mm were expected
          at expect.clearance (cell.toml:2)"#]],
    );
    check(
        200.0,
        "[expect]\nclearance = 45\n",
        expect![[r#"
        failed, 1.688 s
        `link6` is 8.5 mm from `wall` at 1.684 s; at least 45 mm were expected
          at expect.clearance (cell.toml:2)"#]],
    );
    check(
        200.0,
        "[[expect.clearance]]\nabove = 45\nof = [\"wall\", \"rod\"]\n",
        expect![[r#"
        failed, 1.688 s
        `rod` is 40.0 mm from `wall` at 1.684 s; at least 45 mm were expected
          at expect.clearance (cell.toml:1)"#]],
    );
    check(200.0, "[[expect.clearance]]\nabove = 45\nof = [\"wall\", \"link1\"]\n", expect!["ok, 1.688 s"]);
}

#[test]
fn a_contact_is_a_failure_unless_it_is_expected() {
    check(
        150.0,
        "[expect]\nerrors = []\n",
        expect![[r#"
        failed, 1.688 s
        `link6` touches `wall` at 1.596 s
          at start (main/start.pgx:15)
        `link5` touches `wall` at 1.620 s
          at start (main/start.pgx:15)
        `rod` touches `wall` at 1.640 s
          at start (main/start.pgx:15)"#]],
    );
    check(150.0, "[expect]\ncontact = true\n", expect!["ok, 1.688 s"]);
    check(
        200.0,
        "[expect]\ncontact = true\n",
        expect![[r#"
        failed, 1.688 s
        a contact was expected, and nothing has touched anything else
          at expect.contact (cell.toml:2)"#]],
    );
}

#[test]
fn a_thing_without_a_place_has_no_distance() {
    let code = CODE.replace("WALL", "200").replace("joint jReady", "frame fWall\njoint jReady");
    let code = code.replace("name = \"wall\"", "name = \"wall\"\nin = \"fWall\"");
    // A frame that refers to itself has no place.
    let code = code.replace("begin\n", "begin\n  link(fWall,fWall)\n");
    let mut bench = Bench::open(&code, "main");
    let result = bench.scenario("[expect]\nclearance = 20\n");
    expect![[r#"
        failed, 1.688 s
        the distances of `wall` were unknown while the arm moved: the frame or tool had no father, or impossible values
          at expect.clearance (cell.toml:2)"#]]
    .assert_eq(&bench.shown(&result));
}

#[test]
fn expectations_name_things_of_the_cell() {
    let code = CODE.replace("WALL", "200");
    faults(
        &code,
        "[[expect.clearance]]\nabove = 45\nof = [\"wal\", \"rod\"]\n",
        expect!["line 1: the cell has nothing with the name `wal`: did you mean `wall`?"],
    );
    faults(&code, "[expect]\nclearance = 900\n", expect!["line 2: 900 mm is no clearance: write 0 to 500 mm"]);
    faults(
        &code,
        "[[expect.clearance]]\nabove = 45\nof = [\"link1\", \"link5\"]\n",
        expect![
            "line 1: the distance of `link1` and `link5` is not compared: both stand, or belong to the arm, or may touch"
        ],
    );
    let elsewhere = code.replace("name = \"wall\"", "name = \"wall\"\nin = \"fElsewhere\"");
    faults(
        &elsewhere,
        "[expect]\nclearance = 20\n",
        expect!["line 2: `wall` is left out, because this application does not have its frame or tool: name pairs"],
    );
    let (carried, _) = code.split_once("\n[[object]]\nname = \"wall\"").unwrap();
    faults(
        carried,
        "[[expect.clearance]]\nabove = 20\n",
        expect![
            "line 1: the cell has nothing that the arm could come near to, apart from parts, whose distances are limited by name only: name pairs"
        ],
    );
    faults(
        &code,
        "[expect]\nclearance = []\n",
        expect!["line 2: this compares nothing, so it always holds: write what is expected, or remove it"],
    );
    let (empty, _) = code.split_once("===").unwrap();
    faults(
        empty,
        "[expect]\nclearance = 20\ncontact = true\n",
        expect![[r#"
        line 3: there is nothing around the arm: the application has no cell.toml
        line 2: there is nothing around the arm: the application has no cell.toml"#]],
    );
}

#[test]
fn frames_of_applications_in_inches_have_places_in_millimetres() {
    let code = "frame fWall\nprogram start()\nbegin\n  link(fWall,world)\n  fWall.trsf.x=10\nend\n";
    for (listing, expected) in [(code.to_owned(), 10.0), (Fixture::in_inches(code), 254.0)] {
        let mut bench = Bench::open(&listing, "main");
        bench.scenario("");
        let place = bench.controller.frame_in_world("fWall").unwrap();
        assert!((place.translation.x - expected).abs() < 1e-9, "{place}");
    }
}
