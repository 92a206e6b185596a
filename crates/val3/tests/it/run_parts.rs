//! `val3 run` and `val3 test` with parts that a gripper carries.

use expect_test::{Expect, expect};
use serde_json::Value;

use crate::support::Folder;

/// The arm closes its gripper, moves by 100 mm along the axis y, and opens it.
const CODE: &str = "\
joint jReady
point pEnd
mdesc mLine
tool tGrip
frame fTable
dio doValve
dio diPart
program start()
begin
  link(pEnd,world)
  link(fTable,world)
  link(tGrip,flange)
  dioLink(tGrip.gripper,doValve)
  tGrip.trsf.z=150
  tGrip.otime=0.1
  tGrip.ctime=0.05
  mLine.blend=off
  mLine.vel=100
  doValve=true
  wait(isPowered())
  jReady={0,0,90,0,90,0}
  movej(jReady,tGrip,mLine)
  waitEndMove()
  close(tGrip)
  ? diPart
  pEnd=here(tGrip,world)
  pEnd.trsf.y=pEnd.trsf.y+100
  movel(pEnd,tGrip,mLine)
  open(tGrip)
  ? diPart
  waitEndMove()
end
";

/// A part below the flange, the table under the part, a gripper, and a sensor at the part's destination.
const CELL: &str = "\
[[object]]
name = \"table\"
box = { min = [400, -300, -1000], max = [700, 300, 94] }
[[part]]
name = \"carton\"
copies = 2
step = [0, -150, 0]
in = \"fTable\"
box = [40, 40, 80]
at = [475, 50, Z]
[[gripper]]
tool = \"tGrip\"
holding = { \"BasicIO-1\\\\%I0\" = true }
empty = { \"BasicIO-1\\\\%I0\" = false }
[[sensor]]
name = \"end\"
beam = { from = [400, 160, 130], to = [700, 160, 130] }
";

/// A folder in which the first part is this far below the flange.
pub(crate) fn folder(gap: f64) -> Folder {
    let folder = Folder::with(CODE);
    folder.link("doValve", "BasicIO-1\\%Q0");
    folder.link("diPart", "BasicIO-1\\%I0");
    folder.write("val3.toml", "arm = \"tx2-90\"\n[run]\npower = true\n");
    folder.write("cell.toml", &CELL.replace('Z', &(175.0 - 40.0 - gap).to_string()));
    folder
}

/// Events about parts and sensors, one per line.
fn handling(folder: &Folder, args: &[&str]) -> String {
    let run = folder.val3(&[&["run", "--events", "events.jsonl"], args].concat());
    assert_eq!((run.code, run.stderr.as_str()), (0, ""), "{}", run.stdout);
    let events = folder.read("events.jsonl");
    let kinds = ["\"grip\"", "\"release\"", "\"part\"", "\"sensor\""];
    let lines = events.lines().filter(|line| kinds.iter().any(|kind| line.contains(&format!("\"kind\":{kind}"))));
    lines.map(|line| format!("{line}\n")).collect()
}

#[test]
fn a_part_is_gripped_carried_and_released() {
    expect![[r#"
        {"t":0.544,"kind":"grip","gripper":"tGrip","part":"carton[0]","nearest":"carton[0]","distance":1.0,"within":5.0}
        {"t":0.688,"kind":"sensor","sensor":"end","on":true,"detects":"carton[0]"}
        {"t":0.832,"kind":"release","gripper":"tGrip","part":"carton[0]"}
    "#]]
    .assert_eq(&handling(&folder(1.0), &[]));
}

#[test]
fn a_missed_part_is_a_note() {
    let run = folder(12.25).val3(&["run"]);
    expect![[r#"
        note: 0.544 s: `tGrip` grips nothing: no part within 5 mm; `carton[0]` is 12.3 mm away
    "#]]
    .assert_eq(&run.stderr);
    assert_eq!(run.code, 0);
}

#[test]
fn a_script_takes_the_part_away() {
    let folder = folder(1.0);
    folder.write(
        "script.toml",
        "[[when]]\nheld = \"carton[0]\"\nthen = [{ after = 0.2, remove = [\"carton[0]\"] }]\n\
         [[at]]\nt = 0.1\nplace = { \"carton[1]\" = { in = \"base\", at = [0, 900, 0] } }\n",
    );
    expect![[r#"
        {"t":0.1,"kind":"part","part":"carton[1]","state":"placed"}
        {"t":0.544,"kind":"grip","gripper":"tGrip","part":"carton[0]","nearest":"carton[0]","distance":1.0,"within":5.0}
        {"t":0.688,"kind":"sensor","sensor":"end","on":true,"detects":"carton[0]"}
        {"t":0.744,"kind":"part","part":"carton[0]","state":"removed"}
        {"t":0.748,"kind":"sensor","sensor":"end","on":false}
    "#]]
    .assert_eq(&handling(&folder, &["--script", "script.toml"]));
}

#[test]
fn a_script_and_a_gripper_with_the_same_input_are_noted_once() {
    let folder = folder(1.0);
    let io = "io = { \"BasicIO-1\\\\%I0\" = true }";
    folder.write("script.toml", &format!("[[at]]\nt = 0.1\n{io}\n[[at]]\nt = 0.2\n{io}\n"));
    let run = folder.val3(&["run", "--script", "script.toml"]);
    expect![[r#"
        log: the script and the cell both write `BasicIO-1\%I0`: the value of the script stays until the cell's changes
        true
        true
    "#]]
    .assert_eq(&run.stdout);
}

#[test]
fn a_held_part_that_hits_something_is_a_contact() {
    let folder = folder(1.0);
    let post = "[[object]]\nname = \"post\"\nbox = { min = [400, 140, 94], max = [700, 150, 110] }\n";
    folder.write("cell.toml", &format!("{post}{}", folder.read("cell.toml")));
    let run = folder.val3(&["run"]);
    expect![[r#"
        error: `carton[0]` overlaps `post` by 16.0 mm at 0.724 s, in move 1 (movel, start:23)
           ┌─ usrapp/main/start.pgx:23:3
           │
        23 │   movel(pEnd,tGrip,mLine)
           │   ^^^^^^^^^^^^^^^^^^^^^^^ during the move of this line
           │
           = help: move one of them, or allow the pair in cell.toml: allow = [["carton[0]", "post", "the reason"]]

    "#]]
    .assert_eq(&run.stderr);
    assert_eq!(run.code, 1);
}

/// Executes a scenario, and returns the report.
fn scenario(folder: &Folder, text: &str) -> String {
    folder.write("tests/one.toml", &format!("application = \"../usrapp/main\"\n{text}"));
    let run = folder.val3(&["test", "tests"]);
    run.stdout + &run.stderr
}

#[track_caller]
fn check(text: &str, expected: Expect) {
    expected.assert_eq(&scenario(&folder(1.0), text));
}

#[test]
fn tests_expect_where_parts_are() {
    check(
        "[expect]\nseen = \"end\"\nheld = { \"carton[0]\" = false }\n\
         placed = { \"carton[0]\" = { in = \"fTable\", is = [475, 150, 134], within = 0.5 }, \
                \"carton[1]\" = { is = [475, -100, 134, 0, 0, 0] } }\n\
         [[expect.order]]\nevents = [{ held = \"carton[0]\" }, { seen = \"end\" }, { held = { \"carton[0]\" = false } }]\n",
        expect![[r#"
            main
              ok    one (0.832 s)
            1 passed, 0 failed
        "#]],
    );
}

#[test]
fn tests_name_the_places_of_parts_that_are_elsewhere() {
    check(
        "[expect]\nseen = { end = false }\nheld = [\"carton[0]\", \"carton[1]\"]\n\
         placed = { \"carton[0]\" = { in = \"fTable\", is = [475, 152, 134] }, \
                \"carton[1]\" = { is = [475, -100, 134, 0, 0, 5] } }\n",
        expect![[r#"
            main
              FAIL  one (0.832 s)
                    `end` is interrupted, at 0.832 s
                    at expect.seen (tests/one.toml:3)
                        3 │ seen = { end = false }
                    `carton[0]` is not held; `carton[1]` is not held, at 0.832 s
                    at expect.held (tests/one.toml:4)
                        4 │ held = ["carton[0]", "carton[1]"]
                    `carton[0]` is 2.1 mm from its place: at [475.0, 149.9, 134.0] in `fTable`, at 0.832 s
                    at expect.placed (tests/one.toml:5)
                        5 │ placed = { "carton[0]" = { in = "fTable", is = [475, 152, 134] }, "carton[1]" = { is = [475, -100, 134, 0, 0, 5] } }
                    `carton[1]` is 5.0 degrees from its place: at [475.0, -100.0, 134.0, 0.0, 0.0, 0.0] in `world`, at 0.832 s
                    at expect.placed (tests/one.toml:5)
                        5 │ placed = { "carton[0]" = { in = "fTable", is = [475, 152, 134] }, "carton[1]" = { is = [475, -100, 134, 0, 0, 5] } }
                    | false
                    | true
                    last events:
                      0.000 s  power on
                      0.004 s  movej 0 started, start:17
                      0.492 s  BasicIO-1\%Q0 = 0
                      0.540 s  movel 1 started, start:23
                      0.544 s  BasicIO-1\%I0 = 1
                      0.732 s  BasicIO-1\%Q0 = 1, 2 times since 0.004 s
            0 passed, 1 failed
        "#]],
    );
    check(
        "[[expect.at]]\nt = 0.8\nheld = \"carton[1]\"\nplaced = { \"carton[0]\" = { is = [0, 0, 0] } }\n",
        expect![[r#"
        main
          FAIL  one (0.832 s)
                `carton[1]` is not held, at 0.8 s
                at expect.at.held (tests/one.toml:4)
                    4 │ held = "carton[1]"
                `carton[0]` is 515.8 mm from its place: at [475.0, 149.9, 134.0] in `world`, held by a gripper, at 0.8 s
                at expect.at.placed (tests/one.toml:5)
                    5 │ placed = { "carton[0]" = { is = [0, 0, 0] } }
                | false
                | true
                last events:
                  0.000 s  power on
                  0.004 s  movej 0 started, start:17
                  0.492 s  BasicIO-1\%Q0 = 0
                  0.540 s  movel 1 started, start:23
                  0.544 s  BasicIO-1\%I0 = 1
                  0.732 s  BasicIO-1\%Q0 = 1, 2 times since 0.004 s
        0 passed, 1 failed
    "#]],
    );
}

#[test]
fn unknown_parts_and_sensors_are_faults() {
    check(
        "[expect]\nseen = \"ende\"\nheld = \"carton\"\nplaced = { \"carton[2]\" = { in = \"fTabel\", is = [1, 2, 3] } }\n\
         [[when]]\nheld = \"karton[0]\"\nthen = [{ remove = \"carton[9]\" }]\n",
        expect![[r#"
            main
              FAIL  one (0.000 s)
                    the script `tests/one.toml` cannot be used
                      [[when]] in line 6: there is no part `karton[0]`; did you mean `carton[0]`?
                      [[when]] in line 6: there is no part `carton[9]`; did you mean `carton[0]`, `carton[1]`?
                      line 3: there is no sensor `ende`; did you mean `end`?
                      line 4: there is no part `carton`; did you mean `carton[0]`, `carton[1]`?
                      line 5: there is no part `carton[2]`; did you mean `carton[0]`, `carton[1]`?
                      line 5: there is no frame `fTabel`; did you mean `fTable`?
                    at main:one (tests/one.toml:1)
                        1 │ application = "../usrapp/main"
            0 passed, 1 failed
        "#]],
    );
}

#[test]
fn the_same_run_has_the_same_events() {
    let (first, second) = (folder(1.0), folder(1.0));
    let events = |folder: &Folder| {
        folder.val3(&["run", "--events", "events.jsonl"]);
        folder.read("events.jsonl")
    };
    let (first, second) = (events(&first), events(&second));
    assert_eq!(first, second);
    assert!(first.lines().all(|line| serde_json::from_str::<Value>(line).is_ok()));
}
