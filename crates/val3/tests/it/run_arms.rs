//! Messages about invalid arms and impossible moves.

use expect_test::{Expect, expect};

use crate::support::Folder;

/// Runs `val3 run` with an arm; the message must be the only output.
#[track_caller]
fn refused(folder: &Folder, arm: &str, message: &Expect) {
    let run = folder.val3(&["run", "--arm", arm]);
    assert_eq!((run.code, run.stdout.as_str()), (2, ""), "{}", run.stderr);
    message.assert_eq(&run.stderr);
}

#[test]
fn an_unknown_arm_has_a_proposal() {
    let folder = Folder::with("? 1\n");
    refused(
        &folder,
        "RX13B",
        &expect![[r#"
        error: the arm `RX13B` is not known
          help: did you mean `RX130B`?
    "#]],
    );
    refused(
        &folder,
        "kuka",
        &expect![[r#"
        error: `kuka` is not an arm; write "six-axis", "scara", "other", a model such as "tx2-60l", or the path of a file such as "cell/my-arm.toml"
    "#]],
    );
    refused(
        &folder,
        "missing.toml",
        &expect![[r#"
        error: the arm of `missing.toml` cannot be used: it does not exist
          help: a shipped file shows the form: `val3 arm show TX2-90`
    "#]],
    );
}

/// A valid arm file.
const ARM: &str = r#"name = "mine"
kind = "six-axis"
[geometry]
a1 = 50
b = 50
c2 = 425
c3 = 425
c4 = 100
[axes]
min = [-180, -130, -145, -270, -115, -270]
max = [180, 147.5, 145, 270, 140, 270]
maximum_speed = [400, 400, 430, 540, 475, 760]
"#;

/// Start of the messages about arm files.
const WRONG: &str = "error: the arm of `my.toml` cannot be used: ";

#[test]
fn a_file_describes_an_arm() {
    let folder = Folder::with("? getVersion(\"ArmType\")\n");
    folder.write("my.toml", ARM);
    let run = folder.val3(&["run", "--arm", "my.toml"]);
    assert_eq!((run.stdout.as_str(), run.stderr.as_str(), run.code), ("mine\n", "", 0));
}

#[test]
fn a_file_without_sense_is_refused_with_its_line() {
    let folder = Folder::with("? 1\n");
    let mut messages = String::new();
    for (from, to) in [
        (ARM, "<arm/>"),
        (ARM, ""),
        ("c2 = 425", "c2 = -425"),
        ("c2 = 425", "c2 = nan"),
        ("c2 = 425", "c2 = 1e300"),
        ("c2 = 425", "c2 = \"long\""),
        ("c2 = 425\n", ""),
        ("min = [-180,", "min = [181,"),
        ("min = [-180,", "min = [-inf,"),
        ("max = [180, ", "max = ["),
        ("speed = [400,", "speed = [0,"),
        ("\"six-axis\"", "\"delta\""),
        ("\"six-axis\"", "\"scara\""),
        ("[axes]", "[axis]"),
    ] {
        folder.write("my.toml", &ARM.replace(from, to));
        let run = folder.val3(&["run", "--arm", "my.toml"]);
        assert_eq!((run.code, run.stdout.as_str()), (2, ""), "{to}");
        let reason = run.stderr.lines().next().and_then(|line| line.strip_prefix(WRONG));
        messages += &format!("`{to}`\n    {}\n", reason.unwrap_or(&run.stderr));
    }
    expect![[r#"
        `<arm/>`
            line 1: key with no value, expected `=`
        ``
            line 1: missing field `name`
        `c2 = -425`
            line 6, geometry.c2: -425 must be greater than 0
        `c2 = nan`
            line 6, geometry.c2: NaN is no usable number, write one between -1000000 and 1000000
        `c2 = 1e300`
            line 6, geometry.c2: 1e300 is no usable number, write one between -1000000 and 1000000
        `c2 = "long"`
            line 6: invalid type: string "long", expected a number
        ``
            line 3, geometry.c2: a six-axis arm needs this length, add it in mm
        `min = [181,`
            line 10, axes.min: axis 1 has min = 181 and max = 180, min must be less than max
        `min = [-inf,`
            line 10, axes.min: axis 1: -inf is no usable number, write one between -1000000 and 1000000
        `max = [`
            line 11, axes.max: a six-axis arm has 6 axes, but this has 5 values
        `speed = [0,`
            line 12, axes.maximum_speed: axis 1: 0 must be greater than 0
        `"delta"`
            line 2: unknown variant `delta`, expected `six-axis` or `scara`
        `"scara"`
            line 4, geometry.a1: a SCARA arm has no such length, remove it
        `[axis]`
            line 9: unknown field `axis`, expected one of `name`, `kind`, `sources`, `model`, `times`, `geometry`, `axes`, `payload`, `shapes`
    "#]].assert_eq(&messages);
}

/// If the cell names an unknown arm, the run reports its replacement.
#[test]
fn an_unknown_arm_of_the_cell_is_replaced_with_a_note() {
    let folder = Folder::with("? getVersion(\"ArmType\")\n? isInRange({0,0,0,0,0,0})\n");
    folder.write("configs/arm.cfx", "<arm><String name=\"arm\" value=\"tx9000-S1\"/></arm>");
    let run = folder.val3(&["run"]);
    assert_eq!((run.stdout.as_str(), run.code), ("tx9000-S1\ntrue\n", 0));
    expect![[r#"
        note: the arm `tx9000-S1` of arm.cfx is unknown: this run has a TX2-90; describe yours in a file (--arm FILE.toml)
    "#]].assert_eq(&run.stderr);
}

/// Data and power for every program. The arm is at {0,0,90,0,90,0}, its flange at x = 475 mm, y = 50 mm, z = 325 mm.
const HEAD: &str = "joint j\npoint p\npoint pEnd\nmdesc m\nframe fA\nframe fB\ntool tA\ntool tB\n  m.blend=off\n  enablePower()\n  wait(isPowered())\n  \
                    j={0,0,90,0,90,0}\n  movej(j,flange,m)\n  waitEndMove()\n  p=here(flange,world)\n";

#[track_caller]
fn stops(body: &str, message: Expect) {
    let folder = Folder::with(&format!("{HEAD}{body}"));
    let run = folder.val3(&["run", "--arm", "TX2-90", "--until", "60"]);
    assert_eq!(run.code, 1, "{run:?}");
    message.assert_eq(&run.stderr);
}

#[test]
fn targets_out_of_reach_are_refused_with_a_reason() {
    stops(
        "  p.trsf.x=5000\n  movel(p,flange,m)\n",
        expect![[r#"
            error[154]: move not possible (task `main~`)
               ┌─ usrapp/main/start.pgx:13:3
               │
            13 │   movel(p,flange,m)
               │   ^^^^^^^^^^^^^^^^^ movel: the centre of the wrist would be 4968.2 mm from the shoulder, the arm reaches 0.0 to 850.0 mm
               │
               = help: The target, or the line or circle to it, is out of reach or out of the limits, or the motion descriptor does not suit it.

        "#]],
    );
    stops(
        "  p.trsf.x=5000\n  movej(p,flange,m)\n",
        expect![[r#"
            error[154]: move not possible (task `main~`)
               ┌─ usrapp/main/start.pgx:13:3
               │
            13 │   movej(p,flange,m)
               │   ^^^^^^^^^^^^^^^^^ movej: the centre of the wrist would be 4968.2 mm from the shoulder, the arm reaches 0.0 to 850.0 mm
               │
               = help: The target, or the line or circle to it, is out of reach or out of the limits, or the motion descriptor does not suit it.

        "#]],
    );
    stops(
        "  p.trsf.x=20\n  p.trsf.y=0\n  movej(p,flange,m)\n",
        expect![[r#"
            error[154]: move not possible (task `main~`)
               ┌─ usrapp/main/start.pgx:14:3
               │
            14 │   movej(p,flange,m)
               │   ^^^^^^^^^^^^^^^^^ movej: the centre of the wrist would be 20.0 mm from axis 1, the arm needs at least 50.0 mm
               │
               = help: The target, or the line or circle to it, is out of reach or out of the limits, or the motion descriptor does not suit it.

        "#]],
    );
    stops(
        "  j.j2=150\n  movej(j,flange,m)\n",
        expect![[r#"
            error[154]: move not possible (task `main~`)
               ┌─ usrapp/main/start.pgx:13:3
               │
            13 │   movej(j,flange,m)
               │   ^^^^^^^^^^^^^^^^^ movej: axis 2 would be at 150.000, outside its range from -130 to 147.5 degrees
               │
               = help: The target, or the line or circle to it, is out of reach or out of the limits, or the motion descriptor does not suit it.

        "#]],
    );
    stops(
        "  p.trsf.y=p.trsf.y+50\n  p.config.shoulder=righty\n  movel(p,flange,m)\n",
        expect![[r#"
            error[154]: move not possible (task `main~`)
               ┌─ usrapp/main/start.pgx:14:3
               │
            14 │   movel(p,flange,m)
               │   ^^^^^^^^^^^^^^^^^ movel: a straight line or a circle cannot change the configuration; use a joint move, or `free`
               │
               = help: The target, or the line or circle to it, is out of reach or out of the limits, or the motion descriptor does not suit it.

        "#]],
    );
}

#[test]
fn circles_that_do_not_exist_are_refused_with_a_reason() {
    stops(
        "  pEnd=appro(p,{100,0,0,0,0,0})\n  movec(appro(p,{50,0,0,0,0,0}),pEnd,flange,m)\n",
        expect![[r#"
            error[154]: move not possible (task `main~`)
               ┌─ usrapp/main/start.pgx:13:3
               │
            13 │   movec(appro(p,{50,0,0,0,0,0}),pEnd,flange,m)
               │   ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^ movec: the three positions are on one line
               │
               = help: The target, or the line or circle to it, is out of reach or out of the limits, or the motion descriptor does not suit it.

        "#]],
    );
    stops(
        "  pEnd=appro(p,{100,0,0,0,0,0})\n  movec(p,pEnd,flange,m)\n",
        expect![[r#"
            error[154]: move not possible (task `main~`)
               ┌─ usrapp/main/start.pgx:13:3
               │
            13 │   movec(p,pEnd,flange,m)
               │   ^^^^^^^^^^^^^^^^^^^^^^ movec: two of the three positions are the same
               │
               = help: The target, or the line or circle to it, is out of reach or out of the limits, or the motion descriptor does not suit it.

        "#]],
    );
    stops(
        "  movec(appro(p,{50,50,0,0,0,0}),p,flange,m)\n",
        expect![[r#"
            error[154]: move not possible (task `main~`)
               ┌─ usrapp/main/start.pgx:12:3
               │
            12 │   movec(appro(p,{50,50,0,0,0,0}),p,flange,m)
               │   ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^ movec: two of the three positions are the same
               │
               = help: The target, or the line or circle to it, is out of reach or out of the limits, or the motion descriptor does not suit it.

        "#]],
    );
    stops(
        "  pEnd=appro(p,{100,0,0,0,0,0})\n  movec(appro(p,{50,50,0,0,0,180}),pEnd,flange,m)\n",
        expect![[r#"
            error[154]: move not possible (task `main~`)
               ┌─ usrapp/main/start.pgx:13:3
               │
            13 │   movec(appro(p,{50,50,0,0,0,180}),pEnd,flange,m)
               │   ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^ movec: the intermediate position does not determine which way the orientation turns
               │
               = help: The target, or the line or circle to it, is out of reach or out of the limits, or the motion descriptor does not suit it.

        "#]],
    );
}

#[test]
fn descriptors_out_of_range_are_refused() {
    stops(
        "  m.vel=0\n  movej(j,flange,m)\n",
        expect![[r#"
        error[100]: bad vel in the mdesc (task `main~`)
           ┌─ usrapp/main/start.pgx:13:3
           │
        13 │   movej(j,flange,m)
           │   ^^^^^^^^^^^^^^^^^ the task stopped here
           │
           = help: The joint speed of the motion descriptor is zero, negative or too large; it is a percentage.

    "#]],
    );
    stops(
        "  m.vel=1001\n  movej(j,flange,m)\n",
        expect![[r#"
        error[100]: bad vel in the mdesc (task `main~`)
           ┌─ usrapp/main/start.pgx:13:3
           │
        13 │   movej(j,flange,m)
           │   ^^^^^^^^^^^^^^^^^ the task stopped here
           │
           = help: The joint speed of the motion descriptor is zero, negative or too large; it is a percentage.

    "#]],
    );
    stops(
        "  m.accel=-1\n  movej(j,flange,m)\n",
        expect![[r#"
        error[101]: bad accel in the mdesc (task `main~`)
           ┌─ usrapp/main/start.pgx:13:3
           │
        13 │   movej(j,flange,m)
           │   ^^^^^^^^^^^^^^^^^ the task stopped here
           │
           = help: The acceleration of the motion descriptor is zero, negative or too large; it is a percentage.

    "#]],
    );
    stops(
        "  m.tvel=0\n  movel(p,flange,m)\n",
        expect![[r#"
        error[103]: bad tvel in the mdesc (task `main~`)
           ┌─ usrapp/main/start.pgx:13:3
           │
        13 │   movel(p,flange,m)
           │   ^^^^^^^^^^^^^^^^^ the task stopped here
           │
           = help: The speed of the tool centre point is zero, negative or too large; it counts millimetres or inches per second.

    "#]],
    );
    stops(
        "  m.leave=-1\n  movej(j,flange,m)\n",
        expect![[r#"
        error[106]: bad leave in the mdesc (task `main~`)
           ┌─ usrapp/main/start.pgx:13:3
           │
        13 │   movej(j,flange,m)
           │   ^^^^^^^^^^^^^^^^^ the task stopped here
           │
           = help: The distance at which blending starts is negative.

    "#]],
    );
}

/// Frames and tools with circular references have no placement.
#[test]
fn frames_and_tools_in_a_loop_are_errors_where_they_are_used() {
    stops(
        "  link(fA,fB)\n  link(fB,fA)\n  link(p,fA)\n  movel(p,flange,m)\n",
        expect![[r#"
            error[163]: frame without reference (task `main~`)
               ┌─ usrapp/main/start.pgx:15:3
               │
            15 │   movel(p,flange,m)
               │   ^^^^^^^^^^^^^^^^^ the task stopped here
               │
               = help: The frame has no reference frame. Give it one with link, setFrame or by an assignment; local frames have none at first. References that form a circle count as none.

        "#]],
    );
    stops(
        "  link(tA,tB)\n  link(tB,tA)\n  movel(p,tA,m)\n",
        expect![[r#"
            error[164]: tool without reference (task `main~`)
               ┌─ usrapp/main/start.pgx:14:3
               │
            14 │   movel(p,tA,m)
               │   ^^^^^^^^^^^^^ the task stopped here
               │
               = help: The tool has no reference tool. Give it one with link or by an assignment; local tools have none at first. References that form a circle count as none.

        "#]],
    );
}

/// The check finds the circular reference in the data, and the run does not start.
#[test]
fn a_loop_of_frames_in_the_data_is_found_before_the_run() {
    let folder = Folder::with("frame fA\nframe fB\n? 1\n");
    let data = folder.read("usrapp/main/main.dtx");
    let looped = data.replacen("world[0]", "fB[0]", 1).replacen("world[0]", "fA[0]", 1);
    folder.write("usrapp/main/main.dtx", &looped);
    let run = folder.val3(&["run"]);
    assert_eq!((run.code, run.stdout.as_str()), (1, ""));
    expect![[r#"
        error[V0522]: the fathers form a circle: `fA` -> `fB` -> `fA`
          ┌─ usrapp/main/main.dtx:5:32
          │
        5 │       <Value key="0" fatherId="fB[0]" />
          │                                ^^^^^ closes the circle
          │
          = help: set one of the fathers to `world[0]` (frames) or `flange[0]` (tools)

    "#]]
    .assert_eq(&run.stderr);
}

/// `vel` is a percentage of the nominal speeds, and may exceed an axis' maximum speed. Each line warns once.
#[test]
fn a_speed_beyond_the_maximum_of_an_axis_is_a_warning() {
    let moves = "mdesc m\njoint jA\njoint jB\nnum nI\n  enablePower()\n  wait(isPowered())\n  m.vel=150\n  \
                 jB={30,0,0,0,0,0}\n  movej(jB,flange,m)\n  m.vel=160\n  for nI=1 to 3\n    movej(jA,flange,m)\n    \
                 movej(jB,flange,m)\n  endFor\n  m.vel=100\n  movej(jA,flange,m)\n  waitEndMove()\n";
    let folder = Folder::with(moves);
    expect![[r#"
        {"t":1.004012,"task":"main~","kind":"log","level":"warning","text":"movej at start:12: with vel = 160 axis 1 may move at 424 degrees/s, its maximum is 400 degrees/s; use vel = 150 at most"}
        {"t":1.004014,"task":"main~","kind":"log","level":"warning","text":"movej at start:13: with vel = 160 axis 1 may move at 424 degrees/s, its maximum is 400 degrees/s; use vel = 150 at most"}
    "#]].assert_eq(&warnings(&folder, "TX2-90"));
    // The maximum speeds of an RX60 are assumptions of the model.
    assert_eq!(warnings(&folder, "RX60"), "");
}

/// Events of a run that are warnings.
fn warnings(folder: &Folder, arm: &str) -> String {
    let run = folder.val3(&["run", "--arm", arm, "--events", "-"]);
    assert_eq!(run.code, 0, "{run:?}");
    let lines = run.stdout.lines().filter(|line| line.contains("warning"));
    lines.map(|line| line.to_owned() + "\n").collect()
}
