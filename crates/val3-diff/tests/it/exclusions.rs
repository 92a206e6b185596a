//! Differences that are omitted on request, and statistics.

use expect_test::{Expect, expect};
use val3_diff::format::{human, json, markdown};
use val3_diff::report::Detail;
use val3_diff::{BlankComparison, Comparison, Exclusions, compare_with};

use crate::support::{human, tree};

fn data(values: &str) -> String {
    format!(
        "cls()\n=== main/main.dtx\n<Database xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" \
         xmlns=\"http://www.staubli.com/robotics/VAL3/Data/2\"><Datas>{values}</Datas></Database>"
    )
}

fn value(ty: &str, name: &str, value: &str) -> String {
    format!(
        "<Data name=\"{name}\" access=\"private\" xsi:type=\"array\" type=\"{ty}\" size=\"1\"><Value key=\"0\" {value}/></Data>"
    )
}

fn left_out(old: &str, new: &str, exclusions: &Exclusions) -> Comparison {
    let mut comparison = compare_with(&tree(old), &tree(new), exclusions.layout);
    comparison.leave_out(exclusions);
    comparison
}

fn tolerance(text: &str) -> Exclusions {
    Exclusions { tolerance: Some(text.parse().unwrap()), ..Exclusions::default() }
}

fn names(patterns: &[&str]) -> Exclusions {
    Exclusions { names: patterns.iter().map(|pattern| pattern.parse().unwrap()).collect(), ..Exclusions::default() }
}

#[track_caller]
fn check(old: &str, new: &str, exclusions: &Exclusions, expected: &Expect) {
    expected.assert_eq(&human(&left_out(old, new, exclusions)));
}

fn point_and_number(x: &str, rz: &str, father: &str) -> String {
    data(
        &(value("pointRx", "pA", &format!("x=\"{x}\" rz=\"{rz}\" fatherId=\"{father}\""))
            + &value("num", "nA", &format!("value=\"{x}\""))),
    )
}

#[test]
fn positions_within_the_tolerance_are_counted() {
    let old = point_and_number("5", "0", "world[0]");
    check(
        &old,
        &point_and_number("5.000001", "360", "world[0]"),
        &tolerance("0.01mm,0.01deg"),
        &expect![[r#"
        main  main/main.pjx
          Data
            ~ nA  5 → 5.000001

        1 application differs: 1 value; ignored: 1 position within 0.01 mm and 0.01°
    "#]],
    );
    check(
        &old,
        &point_and_number("5.02", "0", "world[0]"),
        &tolerance("0.01mm,0.01deg"),
        &expect![[r#"
        main  main/main.pjx
          Points, frames and tools
              Position     Moved  Turned  In world  Values
            ~ pA        0.020 mm          0.020 mm  x 5 → 5.02
          Data
            ~ nA  5 → 5.02

        1 application differs: 1 position, 1 value
    "#]],
    );
    // Another father is no small movement, even if the pose is equal.
    check(
        &old,
        &point_and_number("5", "0", "flange[0]"),
        &tolerance("0.01mm,0.01deg"),
        &expect![[r#"
        main  main/main.pjx
          Points, frames and tools
              Position         Moved  Turned    In world  Values
            ~ pA        other father          same place  father world → flange

        1 application differs: 1 position
    "#]],
    );
}

#[test]
fn a_turn_of_an_axis_is_no_small_movement() {
    let joint = |j4: &str, ty: &str, j3: &str| data(&value(ty, "jA", &format!("j3=\"{j3}\" j4=\"{j4}\"")));
    let old = joint("0", "jointRx", "0");
    check(
        &old,
        &joint("0.01", "jointRx", "0"),
        &tolerance("0.01deg"),
        &expect![[r#"
        no differences in 1 application; ignored: 1 position within 0 mm and 0.01°
    "#]],
    );
    check(
        &old,
        &joint("360", "jointRx", "0"),
        &tolerance("0.01deg"),
        &expect![[r#"
        main  main/main.pjx
          Points, frames and tools
            ~ jA  j4 0 → 360

        1 application differs: 1 position
    "#]],
    );
    // The third axis of a SCARA arm is linear.
    check(
        &joint("0", "jointRs", "0"),
        &joint("0", "jointRs", "1"),
        &tolerance("2deg"),
        &expect![[r#"
        main  main/main.pjx
          Points, frames and tools
            ~ jA  j3 0 → 1

        1 application differs: 1 position
    "#]],
    );
    check(
        &joint("0", "jointRs", "0"),
        &joint("0", "jointRs", "1"),
        &tolerance("1mm"),
        &expect![[r#"
        no differences in 1 application; ignored: 1 position within 1 mm and 0°
    "#]],
    );
}

fn turned_frame(rz: &str) -> String {
    data(
        &(value("frame", "fA", &format!("rz=\"{rz}\" fatherId=\"world[0]\""))
            + &value("pointRx", "pNear", "x=\"1\" fatherId=\"fA[0]\"")
            + &value("pointRx", "pFar", "x=\"2000\" fatherId=\"fA[0]\"")),
    )
}

#[test]
fn a_frame_that_moves_a_distant_point_counts() {
    check(
        &turned_frame("0"),
        &turned_frame("0.005"),
        &tolerance("0.01mm,0.01deg"),
        &expect![[r#"
        main  main/main.pjx
          Points, frames and tools
              Position  Moved  Turned  In world  Values
            ~ fA               0.005°    0.005°  rz 0 → 0.005
            ~ fA  1 position moves with it
                pFar  0.175 mm, 0.005°

        1 application differs: 1 position, 1 position that moved along; ignored: 1 position within 0.01 mm and 0.01°
    "#]],
    );
    check(
        &turned_frame("0"),
        &turned_frame("0.005"),
        &tolerance("1mm,1deg"),
        &expect![[r#"
        no differences in 1 application; ignored: 3 positions within 1 mm and 1°
    "#]],
    );
}

fn point(shoulder: &str, x: &str) -> String {
    data(&value("pointRx", "pA", &format!("x=\"{x}\" shoulder=\"{shoulder}\" fatherId=\"world[0]\"")))
}

#[test]
fn other_fields_count() {
    check(
        &point("lefty", "0"),
        &point("righty", "0.001"),
        &tolerance("1mm,1deg"),
        &expect![[r#"
        main  main/main.pjx
          Points, frames and tools
              Position     Moved  Turned  In world  Values
            ~ pA        0.001 mm          0.001 mm  x 0 → 0.001, config.shoulder lefty → righty

        1 application differs: 1 position
    "#]],
    );
}

#[test]
fn ignored_data_are_counted() {
    let old = "num nPartCount = 1\nnum nOther = 1\npublic num nLotCount";
    let new = "num nPartCount = 2\nnum nOther = 2\npublic num nShiftCount";
    check(
        old,
        new,
        &names(&["n*Count"]),
        &expect![[r#"
        main  main/main.pjx
          Data
            ~ nOther  1 → 2

        1 application differs: 1 value; ignored: 3 values named n*Count
    "#]],
    );
    check(
        old,
        new,
        &names(&["n*Count", "nO*"]),
        &expect![[r#"
        no differences in 1 application; ignored: 4 values named n*Count or nO*
    "#]],
    );
    check(
        old,
        new,
        &names(&["nothing"]),
        &expect![[r#"
        main  main/main.pjx
          Interface  no project file here names it
            - data nLotCount  num nLotCount
            + data nShiftCount  num nShiftCount
          Data
            - public num nLotCount
            + public num nShiftCount
            ~ nOther  1 → 2
            ~ nPartCount  1 → 2

        1 application differs: 4 values, 2 public items
    "#]],
    );
}

fn slot(count: u32, x: u32) -> String {
    data(&format!(
        "<Data name=\"tSlot\" access=\"public\" xsi:type=\"array\" type=\"Slot\" size=\"1\"><Value key=\"0\">\
         <Field name=\"nCount\" xsi:type=\"array\" type=\"num\" size=\"1\"><Value key=\"0\" value=\"{count}\"/></Field>\
         <Field name=\"pA\" xsi:type=\"array\" type=\"pointRx\" size=\"1\"><Value key=\"0\" x=\"{x}\" fatherId=\"world[0]\"/>\
         </Field></Value></Data>"
    ))
}

#[test]
fn fields_of_user_types_can_be_ignored() {
    check(
        &slot(1, 1),
        &slot(2, 2),
        &names(&["tSlot.n*"]),
        &expect![[r#"
        main  main/main.pjx
          Points, frames and tools
              Position     Moved  Turned  In world  Values
            ~ tSlot.pA  1.000 mm          1.000 mm  x 1 → 2

        1 application differs: 1 position; ignored: 1 value named tSlot.n*
    "#]],
    );
    check(
        &slot(1, 1),
        &slot(2, 1),
        &names(&["tSlot.n*"]),
        &expect![[r#"
        no differences in 1 application; ignored: 1 value named tSlot.n*
    "#]],
    );
}

fn frame_with_point(x: &str) -> String {
    data(
        &(value("frame", "fA", &format!("x=\"{x}\" fatherId=\"world[0]\""))
            + &value("pointRx", "pA", "fatherId=\"fA[0]\"")),
    )
}

#[test]
fn an_ignored_frame_still_names_what_moved_with_it() {
    check(
        &frame_with_point("0"),
        &frame_with_point("1"),
        &names(&["fA"]),
        &expect![[r#"
            no differences in 1 application; ignored: 1 value named fA, 1 position that moved along
        "#]],
    );
    check(
        &frame_with_point("0"),
        &frame_with_point("1"),
        &names(&["p*"]),
        &expect![[r#"
            main  main/main.pjx
              Points, frames and tools
                  Position     Moved  Turned  In world  Values
                ~ fA        1.000 mm          1.000 mm  x 0 → 1

            1 application differs: 1 position; ignored: 1 position that moved along
        "#]],
    );
}

const PROGRAM: &str = "
program pick(num x_n)
begin
  if x_n>1
    put(x_n)
  endIf
  // look
end
";

#[test]
fn layout_can_be_ignored() {
    let ignored = Exclusions { layout: BlankComparison::Ignored, ..Exclusions::default() };
    let layout = PROGRAM.replace("  if x_n>1", "IF  x_n > 1\n").replace("  // look", "// look ");
    check(
        PROGRAM,
        &layout,
        &ignored,
        &expect![[r#"
        no differences in 1 application; ignored: 1 program in another layout
    "#]],
    );
    check(
        PROGRAM,
        &layout.replace("put(x_n)", "put( 7 )"),
        &ignored,
        &expect![[r#"
        main  main/main.pjx
          Programs
            ~ pick(num x_n)  +1 −1 lines
              1   begin
              2   IF  x_n > 1
              3 -     put(x_n)
              4 +     put( 7 )
              5     endIf
              6   // look
              7   end

        1 application differs: 1 program
    "#]],
    );
    check(
        PROGRAM,
        &layout.replace("look", "Look"),
        &ignored,
        &expect![[r#"
        main  main/main.pjx
          Programs
            ~ pick(num x_n)  only comments differ
              2   IF  x_n > 1
              4       put(x_n)
              5     endIf
              5 -   // look
              6 + // Look
              7   end

        1 application differs: 1 program
    "#]],
    );
    check(
        PROGRAM,
        &layout.replace("pick(num x_n)", "pick(num& x_n)"),
        &ignored,
        &expect![[r#"
        main  main/main.pjx
          Programs
            ~ pick(num& x_n)  same code
                was pick(num x_n)

        1 application differs: 1 program; ignored: 1 program in another layout
    "#]],
    );
}

fn visited_cell(x: &str, count: &str, code: &str) -> String {
    data(
        &(value("frame", "fA", &format!("x=\"{x}\" fatherId=\"world[0]\""))
            + &value("pointRx", "pA", "fatherId=\"fA[0]\"")
            + &value("num", "nA", &format!("value=\"{count}\""))),
    )
    .replace("cls()", code)
        + "\n=== /configs/arm.cfx\n<arm x=\""
        + count
        + "\"/>"
}

fn visit() -> [String; 2] {
    [visited_cell("0", "1", "cls()"), visited_cell("12.5", "2", "put(1)") + "\n=== main/main2.pgx\n<Programs>"]
}

#[test]
fn numbers_can_replace_differences() {
    let [old, new] = visit();
    let comparison = left_out(&old, &new, &Exclusions::default());
    let lines = human::lines(&comparison, Detail::Statistics);
    let text = |line: &human::StyledLine| line.iter().map(|(_, text)| text.as_str()).collect::<String>();
    let shown: String = lines.iter().map(|line| text(line).trim_end().to_owned() + "\n").collect();
    expect![[r#"
              Application    Positions  Moved along  Values  Programs  Files  Other  Greatest movement
            ~ main                   1            1       1         1      1         12.500 mm  fA
            ~ (other files)                                                       1

        Notes
            ! main/main2.pgx  in the new version this is not a program file, so the file was compared as text; `val3 check` shows the faults

        1 application differs: 1 program, 1 position, 1 position that moved along, 1 value, 1 setting, 1 file as text
    "#]].assert_eq(&shown);
    expect![[r#"
        # `` → ``

        1 application differs: 1 program, 1 position, 1 position that moved along, 1 value, 1 setting, 1 file as text

        | Application | Positions | Moved along | Values | Programs | Files | Other | Greatest movement |
        |---|--:|--:|--:|--:|--:|--:|---|
        | `main` | 1 | 1 | 1 | 1 | 1 |  | 12.500 mm  fA |
        | `(other files)` |  |  |  |  |  | 1 |  |

        ## Notes

        - **note** `main/main2.pgx` in the new version this is not a program file, so the file was compared as text; \`val3 check\` shows the faults
    "#]].assert_eq(&markdown::write(&comparison, Detail::Statistics));
    expect![[r#"
        {
          "version": 1,
          "different": true,
          "summary": {
            "applications": 1,
            "programs": 1,
            "points": 1,
            "moved_along": 1,
            "data": 1,
            "io": 0,
            "libraries": 0,
            "interface": 0,
            "configuration": 1,
            "texts": 1,
            "contents": 0,
            "others": 0
          },
          "old": "",
          "new": "",
          "compared": 1,
          "statistics": [
            {
              "name": "main",
              "path": "main/main.pjx",
              "change": "changed",
              "counts": {
                "applications": 1,
                "programs": 1,
                "points": 1,
                "moved_along": 1,
                "data": 1,
                "io": 0,
                "libraries": 0,
                "interface": 0,
                "configuration": 0,
                "texts": 1,
                "contents": 0,
                "others": 0
              },
              "greatest": {
                "path": "fA",
                "displacement": {
                  "distance_mm": 12.5,
                  "angle_deg": 0.0
                }
              }
            },
            {
              "name": null,
              "path": null,
              "change": "changed",
              "counts": {
                "applications": 0,
                "programs": 0,
                "points": 0,
                "moved_along": 0,
                "data": 0,
                "io": 0,
                "libraries": 0,
                "interface": 0,
                "configuration": 1,
                "texts": 0,
                "contents": 0,
                "others": 0
              },
              "greatest": null
            }
          ],
          "ignored": {
            "tolerance": null,
            "within_tolerance": 0,
            "patterns": [],
            "data": 0,
            "moved_along": 0,
            "layouts": 0
          },
          "problems": [
            {
              "path": "main/main2.pgx",
              "side": "new",
              "message": "this is not a program file, so the file was compared as text; `val3 check` shows the faults"
            }
          ]
        }
    "#]]
    .assert_eq(&json::write(&comparison, Detail::Statistics).unwrap());
}
