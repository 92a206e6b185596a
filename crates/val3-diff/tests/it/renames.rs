//! Renamed programs and data.

use expect_test::expect;

use crate::support::check;

const OLD: &str = "
num nCount = 1
num nOther = 1
call pick(1)
nCount=nCount+1
nOther=nCount
program pick(num x_n)
begin
  put(x_n)
  put(nCount)
end
program reset()
begin
  nCount=0
  call reset()
end
";

#[test]
fn renamed_items_and_the_programs_that_follow_are_a_line_each() {
    let new = OLD.replace("nCount", "nParts").replace("pick", "pickPart").replace("reset", "clear");
    check(
        OLD,
        &new,
        &expect![[r#"
        main  main/main.pjx
          Programs
            ~ reset() renamed to clear()
            ~ pick() renamed to pickPart()
            ~ start  only renamed names differ
          Data
            ~ nCount renamed to nParts

        1 application differs: 3 programs, 1 value
    "#]],
    );
}

#[test]
fn other_changes_are_shown_without_the_renames() {
    let new = OLD
        .replace("nCount", "nParts")
        .replace("pick", "pickPart")
        .replace("nOther=nParts", "// note\nnOther=nParts*2")
        .replace("num nParts = 1", "num nParts = 7")
        .replace("put(x_n)", "put(x_n+1)");
    check(
        OLD,
        &new,
        &expect![[r#"
            main  main/main.pjx
              Programs
                - pick(num x_n)  4 lines
                + pickPart(num x_n)  4 lines
                ~ start()  +3 −2 lines
                  1   begin
                  2 - call pick(1)
                  2 + call pickPart(1)
                  3   nParts=nParts+1
                  4 - nOther=nCount
                  4 + // note
                  5 + nOther=nParts*2
                  6   end
                ~ reset  only renamed names differ
              Data
                ~ nCount renamed to nParts
                ~ nParts  1 → 7

            1 application differs: 4 programs, 1 value
        "#]],
    );
}

#[test]
fn another_item_in_the_place_of_a_removed_one_is_no_rename() {
    // Another type, another use, and a name that already existed.
    check(
        "num nA = 1\nnA=1",
        "string sA = \"a\"\nsA=\"b\"",
        &expect![[r#"
        main  main/main.pjx
          Programs
            ~ start()  +1 −1 lines
              1   begin
              2 - nA=1
              2 + sA="b"
              3   end
          Data
            - num nA = 1
            + string sA = "a"

        1 application differs: 1 program, 2 values
    "#]],
    );
    check(
        "num nA = 1\nnum nB\nnA=1\nnA=2",
        "num nB\nnum nC\nnB=1\nnC=2",
        &expect![[r#"
        main  main/main.pjx
          Programs
            ~ start()  +2 −2 lines
              1   begin
              2 - nA=1
              3 - nA=2
              2 + nB=1
              3 + nC=2
              4   end
          Data
            - num nA = 1
            + num nC

        1 application differs: 1 program, 2 values
    "#]],
    );
    // Two counters with the same value, and two programs without code.
    check(
        "num nA = 1\ncls()",
        "num nB = 1\ncls()",
        &expect![[r#"
        main  main/main.pjx
          Data
            - num nA = 1
            + num nB = 1

        1 application differs: 2 values
    "#]],
    );
    let program = |name: &str| format!("cls()\nprogram {name}()\nbegin\nend");
    check(
        &program("a"),
        &program("b"),
        &expect![[r#"
        main  main/main.pjx
          Programs
            - a()  2 lines
            + b()  2 lines

        1 application differs: 2 programs
    "#]],
    );
    // Two programs with the same code.
    let programs = |names: [&str; 2]| names.map(|name| format!("program {name}()\nbegin\n  cls()\nend\n")).concat();
    check(
        &("cls()\n".to_owned() + &programs(["a", "b"])),
        &("cls()\n".to_owned() + &programs(["c", "d"])),
        &expect![[r#"
        main  main/main.pjx
          Programs
            - a()  3 lines
            - b()  3 lines
            + c()  3 lines
            + d()  3 lines

        1 application differs: 4 programs
    "#]],
    );
    // Calls to another program.
    check(
        "call a()\nprogram a()\nbegin\n  cls()\n  put(1)\nend",
        "call b()\nprogram b()\nbegin\n  open(tGrip)\n  waitEndMove()\nend",
        &expect![[r#"
            main  main/main.pjx
              Programs
                - a()  4 lines
                + b()  4 lines
                ~ start()  +1 −1 lines
                  1   begin
                  2 - call a()
                  2 + call b()
                  3   end

            1 application differs: 3 programs
        "#]],
    );
}

fn with_local(local: &str, used: &str) -> String {
    format!("num nOther\nnum {used} = 1\n{used}=2\nprogram a()\n  num {local}\nbegin\n  {local}=1\n  nOther=1\nend")
}

#[test]
fn a_local_variable_hides_a_renamed_name() {
    check(
        &with_local("nA", "nA"),
        &with_local("nA", "nB"),
        &expect![[r#"
        main  main/main.pjx
          Programs
            ~ start  only renamed names differ
          Data
            ~ nA renamed to nB

        1 application differs: 1 program, 1 value
    "#]],
    );
    check(
        &with_local("nA", "nA"),
        &with_local("nB", "nB"),
        &expect![[r#"
        main  main/main.pjx
          Programs
            ~ a()  +1 −1 lines
                removed local num nA
                new local num nB
              1   begin
              2 -   nA=1
              2 +   nB=1
              3     nOther=1
              4   end
            ~ start  only renamed names differ
          Data
            ~ nA renamed to nB

        1 application differs: 2 programs, 1 value
    "#]],
    );
}

fn data(values: &str) -> String {
    format!(
        "cls()\n=== main/main.dtx\n<Database xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" \
         xmlns=\"http://www.staubli.com/robotics/VAL3/Data/2\"><Datas>{values}</Datas></Database>"
    )
}

fn value(ty: &str, name: &str, value: &str) -> String {
    format!(
        "<Data name=\"{name}\" access=\"public\" xsi:type=\"array\" type=\"{ty}\" size=\"1\"><Value key=\"0\" {value}/></Data>"
    )
}

fn frame_and_points(frame: &str, point: &str) -> String {
    data(
        &(value("frame", frame, "x=\"1\" y=\"2\" fatherId=\"world[0]\"")
            + &value("pointRx", point, &format!("x=\"1\" y=\"2\" fatherId=\"{frame}[0]\""))
            + &value("pointRx", "pOther", &format!("x=\"1\" y=\"5\" fatherId=\"{frame}[0]\""))),
    )
}

#[test]
fn data_that_no_program_uses_are_renamed_if_their_content_is_the_same() {
    check(
        &frame_and_points("fOld", "pOld"),
        &frame_and_points("fNew", "pNew"),
        &expect![[r#"
        main  main/main.pjx
          Points, frames and tools
            ~ fOld renamed to fNew
            ~ pOld renamed to pNew

        1 application differs: 2 positions
    "#]],
    );
    let moved = frame_and_points("fNew", "pNew")
        .replace("x=\"1\" y=\"2\" fatherId=\"world", "x=\"9\" y=\"2\" fatherId=\"world");
    check(
        &frame_and_points("fOld", "pOld"),
        &moved,
        &expect![[r#"
        main  main/main.pjx
          Points, frames and tools
            + public frame fNew = x 9, y 2, father world
            - public frame fOld = x 1, y 2, father world
            + public pointRx pNew = x 1, y 2, father fNew
            - public pointRx pOld = x 1, y 2, father fOld
              Position         Moved  Turned  In world  Values
            ~ pOther    other father          8.000 mm  father fOld → fNew

        1 application differs: 5 positions
    "#]],
    );
}
