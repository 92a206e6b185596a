//! Paths that the arm cannot follow, and recorded moves that are discarded at the end of the application.

use expect_test::{Expect, expect};

use crate::support::{CommandOutput, Folder};

/// The arm starts at {0,0,90,0,90,0}. Both lines pass axis 1 at a distance of 80 mm. The blend between them would move
/// the wrist centre through the unreachable cylinder around the axis.
const CUT_CORNER: &str = "joint j\npoint p\nmdesc m\n  m.blend=off\n  enablePower()\n  wait(isPowered())\n  j={0,0,90,0,90,0}\n  \
                          movej(j,flange,m)\n  waitEndMove()\n  p=here(flange,world)\n  p.trsf.x=80\n  p.trsf.y=300\n  \
                          movej(p,flange,m)\n  m.blend=Cartesian\n  m.leave=200\n  m.reach=200\n  p.trsf.y=-80\n  \
                          movel(p,flange,m)\n  p.trsf.x=-300\n  movel(p,flange,m)\n";

fn val3(folder: &Folder, options: &[&str]) -> CommandOutput {
    folder.val3(&[&["run", "--arm", "TX2-90", "--until", "60"], options].concat())
}

#[track_caller]
fn ends(body: &str, code: i32, message: Expect) {
    let run = val3(&Folder::with(body), &[]);
    message.assert_eq(&run.stderr);
    assert_eq!(run.code, code, "{run:?}");
}

#[test]
fn a_path_that_cannot_be_followed_is_reported_without_another_motion_instruction() {
    ends(
        &format!("{CUT_CORNER}  delay(5)\n"),
        1,
        expect![[r#"
            error: the arm cannot follow the path of this `movel`
               ┌─ usrapp/main/start.pgx:19:3
               │
            19 │   movel(p,flange,m)
               │   ^^^^^^^^^^^^^^^^^ on the blend around the destination, the centre of the wrist would be 49.9 mm from axis 1, the arm needs at least 50.0 mm
               │
               = help: The arm stops before the path, and isEmpty() stays false. Correct the move; resetMotion clears the queue.

            note: 2 recorded moves were not executed to the end, because the last task has ended
              movel at usrapp/main/start.pgx:19: movel(p,flange,m)
              movel at usrapp/main/start.pgx:21: movel(p,flange,m)
              help: waitEndMove() waits for recorded moves.
        "#]],
    );
}

#[test]
fn a_condition_that_waits_for_the_arm_has_the_reason() {
    let folder = Folder::with(&format!("{CUT_CORNER}  wait(isEmpty())\n"));
    let run = folder.val3(&["run", "--arm", "TX2-90"]);
    assert_eq!(run.code, 1, "{run:?}");
    expect![[r#"
        error: the arm cannot follow the path of this `movel`
           ┌─ usrapp/main/start.pgx:19:3
           │
        19 │   movel(p,flange,m)
           │   ^^^^^^^^^^^^^^^^^ on the blend around the destination, the centre of the wrist would be 49.9 mm from axis 1, the arm needs at least 50.0 mm
           │
           = help: The arm stops before the path, and isEmpty() stays false. Correct the move; resetMotion clears the queue.

        error: no task can continue after 2.844 s
          task `main~` waits for a condition of the arm, which rests before a path that it cannot follow at usrapp/main/start.pgx:22: wait(isEmpty())
          help: Change what a task waits for in a script (--script), type keys (--keys), or resume the task from another one.
    "#]].assert_eq(&run.stderr);
}

/// Error 150 contains the reason, which is not reported a second time when the arm stops.
#[test]
fn the_next_motion_instruction_has_the_error() {
    ends(
        &format!("{CUT_CORNER}  waitEndMove()\n"),
        1,
        expect![[r#"
        error[150]: motion cannot go on (task `main~`)
           ┌─ usrapp/main/start.pgx:22:3
           │
        22 │   waitEndMove()
           │   ^^^^^^^^^^^^^ a move recorded before cannot be done: the centre of the wrist would be 49.9 mm from axis 1, the arm needs at least 50.0 mm
           │
           = help: A move recorded before cannot be done: out of reach, a singularity, a configuration that the path cannot change. Correct that move; resetMotion clears the queue.

    "#]],
    );
}

#[test]
fn a_path_that_is_discarded_is_no_failure() {
    ends(&format!("{CUT_CORNER}  delay(5)\n  resetMotion()\n"), 0, expect![[""]]);
}

#[test]
fn a_fault_is_one_event_and_a_row_of_the_times() {
    let folder = Folder::with(&format!("{CUT_CORNER}  delay(5)\n"));
    let run = val3(&folder, &["--events", "events.jsonl", "--times"]);
    assert_eq!(run.code, 1, "{run:?}");
    let events = folder.read("events.jsonl");
    let (_, event) = events.split_once("\"kind\":\"fault\",").unwrap();
    let (event, rest) = event.split_once(",\"file\"").unwrap();
    assert!(!rest.contains("\"kind\":\"fault\""), "{rest}");
    expect![[r#""id":2.0,"type":"movel","text":"on the blend around the destination, the centre of the wrist would be 49.9 mm from axis 1, the arm needs at least 50.0 mm","program":"start","line":19"#]].assert_eq(event);
    let rows: Vec<&str> = run.stderr.lines().filter(|line| line.contains("follow")).collect();
    expect![[r#"
        error: the arm cannot follow the path of this `movel`
               3.808 s  58.6 %  start:19  resting before a path that the arm cannot follow
          the arm rests for 3.808 s before a path that it cannot follow: correct the move"#]]
    .assert_eq(&rows.join("\n"));
}

/// The page draws the target where the arm has refused to go.
#[test]
fn the_event_of_a_refused_move_has_its_target() {
    let targets = [
        ("p.trsf={900,0,1500,0,0,0}\n  movel(p,flange,m)", Some("[900.0,0.0,1500.0]")),
        ("movej({0,0,300,0,0,0},flange,m)", Some("[")),
        ("movej({0,0,90,0,90,0},flange,m)", None),
    ];
    for (code, expected) in targets {
        let folder = Folder::with(&format!("point p\nmdesc m\n  enablePower()\n  wait(isPowered())\n  {code}\n"));
        let run = val3(&folder, &["--events", "events.jsonl"]);
        let events = folder.read("events.jsonl");
        let target = events.lines().find(|line| line.contains("\"phase\":\"error\"")).map(|line| {
            let (_, target) = line.split_once("\"target\":").unwrap_or_else(|| panic!("no target: {line}"));
            target
        });
        assert_eq!(target.is_some(), expected.is_some(), "{code}: {run:?}");
        assert!(target.unwrap_or_default().starts_with(expected.unwrap_or_default()), "{code}: {target:?}");
    }
}

/// Manual 10.6: `movel` raises the error if no straight line to its target exists.
#[test]
fn a_line_that_cannot_be_followed_is_an_error_of_its_own_instruction() {
    let code = "point p\nmdesc m\n  m.blend=off\n  enablePower()\n  wait(isPowered())\n  movej({0,0,90,0,5,0},flange,m)\n  \
                waitEndMove()\n  p=jointToPoint(flange,world,{0,0,90,0,-5,0})\n  p.config={ssame,esame,wsame}\n  \
                movel(p,flange,m)\n  delay(5)\n";
    ends(
        code,
        1,
        expect![[r#"
            error[154]: move not possible (task `main~`)
               ┌─ usrapp/main/start.pgx:12:3
               │
            12 │   movel(p,flange,m)
               │   ^^^^^^^^^^^^^^^^^ movel: the path passes a singularity, where an axis would have to jump
               │
               = help: The target, or the line or circle to it, is out of reach or out of the limits, or the motion descriptor does not suit it.

        "#]],
    );
    let turn = "point p\nmdesc m\n  m.blend=off\n  enablePower()\n  wait(isPowered())\n  movej({0,0,90,0,90,260},flange,m)\n  \
                waitEndMove()\n  p=appro(here(flange,world),{0,0,0,0,0,90})\n  movel(p,flange,m)\n";
    ends(
        turn,
        1,
        expect![[r#"
            error[154]: move not possible (task `main~`)
               ┌─ usrapp/main/start.pgx:11:3
               │
            11 │   movel(p,flange,m)
               │   ^^^^^^^^^^^^^^^^^ movel: axis 6 would be at 270.012, its limits are -270 and 270 degrees
               │
               = help: The target, or the line or circle to it, is out of reach or out of the limits, or the motion descriptor does not suit it.

        "#]],
    );
    let circle = "point p\nmdesc m\n  m.blend=off\n  enablePower()\n  wait(isPowered())\n  movej({0,0,90,0,90,0},flange,m)\n  \
                  waitEndMove()\n  p=here(flange,world)\n  movec(appro(p,{2000,50,0,0,0,0}),appro(p,{0,100,0,0,0,0}),flange,m)\n";
    ends(
        circle,
        1,
        expect![[r#"
            error[154]: move not possible (task `main~`)
               ┌─ usrapp/main/start.pgx:11:3
               │
            11 │   movec(appro(p,{2000,50,0,0,0,0}),appro(p,{0,100,0,0,0,0}),flange,m)
               │   ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^ movec: at the intermediate point, the centre of the wrist would be 1537.4 mm from the shoulder, the arm reaches 0.0 to 850.0 mm
               │
               = help: The target, or the line or circle to it, is out of reach or out of the limits, or the motion descriptor does not suit it.

        "#]],
    );
}

#[test]
fn moves_that_the_last_task_leaves_undone_are_named() {
    let code = "mdesc m\n  enablePower()\n  wait(isPowered())\n  movej({0,0,90,0,90,0},flange,m)\n  \
                movej({10,0,90,0,90,0},flange,m)\n";
    ends(
        code,
        0,
        expect![[r#"
        note: 2 recorded moves were not executed to the end, because the last task has ended
          movej at usrapp/main/start.pgx:7: movej({0,0,90,0,90,0},flange,m)
          movej at usrapp/main/start.pgx:8: movej({10,0,90,0,90,0},flange,m)
          help: waitEndMove() waits for recorded moves.
    "#]],
    );
    ends(&format!("{code}  waitEndMove()\n"), 0, expect![[""]]);
    ends(
        CUT_CORNER,
        1,
        expect![[r#"
            error: the arm cannot follow the path of this `movel`
               ┌─ usrapp/main/start.pgx:19:3
               │
            19 │   movel(p,flange,m)
               │   ^^^^^^^^^^^^^^^^^ on the blend around the destination, the centre of the wrist would be 49.9 mm from axis 1, the arm needs at least 50.0 mm
               │
               = help: The arm stops before the path, and isEmpty() stays false. Correct the move; resetMotion clears the queue.

            note: 3 recorded moves were not executed to the end, because the last task has ended
              movej at usrapp/main/start.pgx:14: movej(p,flange,m)
              movel at usrapp/main/start.pgx:19: movel(p,flange,m)
              movel at usrapp/main/start.pgx:21: movel(p,flange,m)
              help: waitEndMove() waits for recorded moves.
        "#]],
    );
}
