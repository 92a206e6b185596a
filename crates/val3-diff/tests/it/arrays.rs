//! Arrays: removed and inserted elements, and renumbered elements.

use std::fmt::Write as _;

use expect_test::expect;
use val3_diff::format::json;
use val3_diff::report::Detail;

use crate::support::{check, compared, human};

/// Returns an application with an array of points `p` and a program.
fn points(places: &[String]) -> String {
    let values = places.iter().enumerate().fold(String::new(), |mut out, (key, place)| {
        write!(out, "<Value key=\"{key}\" {place} fatherId=\"world[0]\"/>").unwrap();
        out
    });
    let size = places.len();
    format!(
        "cls()\n=== main/main.dtx\n<Database xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" \
         xmlns=\"http://www.staubli.com/robotics/VAL3/Data/2\"><Datas>\
         <Data name=\"p\" access=\"private\" xsi:type=\"array\" type=\"pointRx\" size=\"{size}\">{values}</Data></Datas></Database>"
    )
}

fn numbers(values: &[i32]) -> String {
    let text = values.iter().enumerate().fold(String::new(), |mut out, (key, value)| {
        write!(out, "<Value key=\"{key}\" value=\"{value}\"/>").unwrap();
        out
    });
    let size = values.len();
    format!(
        "cls()\n=== main/main.dtx\n<Database xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" \
         xmlns=\"http://www.staubli.com/robotics/VAL3/Data/2\"><Datas>\
         <Data name=\"n\" access=\"private\" xsi:type=\"array\" type=\"num\" size=\"{size}\">{text}</Data></Datas></Database>"
    )
}

/// Returns a row of positions at a distance of 100 mm.
fn row(count: usize) -> Vec<String> {
    (0..count).map(|index| format!("x=\"{}\" y=\"{}\"", 100 * (index + 1), index % 7)).collect()
}

#[test]
fn a_removed_element_is_named_with_the_elements_after_it() {
    let old = row(1000);
    check(
        &points(&old),
        &points(&old[1..]),
        &expect![[r#"
        main  main/main.pjx
          Points, frames and tools
            ~ p  size 1000 → 999
            - p[0]  removed, the 999 after it moved up by one
                x 100, father world
                programs address elements by index: 1000 indexes differ, by up to 100.180 mm

        1 application differs: 1 position
    "#]],
    );
    let mut middle = old.clone();
    middle.drain(3..6);
    check(
        &points(&old),
        &points(&middle),
        &expect![[r#"
        main  main/main.pjx
          Points, frames and tools
            ~ p  size 1000 → 997
            - p[3–5]  removed, the 994 after them moved up by 3
                p[3]  x 400, y 3, father world
                p[4]  x 500, y 4, father world
                p[5]  x 600, y 5, father world
                programs address elements by index: 997 indexes differ, by up to 300.027 mm

        1 application differs: 3 positions
    "#]],
    );
}

#[test]
fn an_inserted_element_is_named_with_the_elements_after_it() {
    let old = row(10);
    let mut new = old.clone();
    new.insert(8, "x=\"5\"".to_owned());
    new[9] = "x=\"900.5\" y=\"1\"".to_owned();
    check(
        &points(&old),
        &points(&new),
        &expect![[r#"
        main  main/main.pjx
          Points, frames and tools
            ~ p  size 10 → 11
            + p[9]  inserted, the element after it moved down by one
                x 900.5, y 1, father world
                programs address elements by index: 3 indexes differ, by up to 895.001 mm
              Position       Moved  Turned    In world  Values
            ~ p[8]      895.001 mm          895.001 mm  x 900 → 5, y 1 → 0

        1 application differs: 2 positions
    "#]],
    );
}

#[test]
fn several_edits_name_the_new_indexes() {
    let old = row(20);
    let mut new = old.clone();
    new.remove(15);
    new.insert(4, "x=\"5\"".to_owned());
    check(
        &points(&old),
        &points(&new),
        &expect![[r#"
        main  main/main.pjx
          Points, frames and tools
            - p[15]  x 1600, y 1, father world
            + p[4]  x 5, father world
                p[4–14] is now p[5–15]
                programs address elements by index: 12 indexes differ, by up to 495.016 mm

        1 application differs: 2 positions
    "#]],
    );
}

#[test]
fn programs_can_read_which_elements_have_another_index() {
    let old = row(1000);
    let document = json::write(&compared(&points(&old), &points(&old[1..])), Detail::Full).unwrap();
    let document: serde_json::Value = serde_json::from_str(&document).unwrap();
    let data = &document["applications"][0]["data"][0];
    assert_eq!(
        data["renumbering"],
        serde_json::json!({
            "runs": [{"old": 1, "new": 0, "count": 999}], "differing_indexes": 1000, "greatest_distance_mm": 100.179838
        })
    );
    assert_eq!((data["values"].as_array().unwrap().len(), &data["values"][0]["path"]), (1, &"p".into()));
    assert_eq!(document["summary"]["points"], 1);
}

#[test]
fn numbers_are_compared_by_index_unless_the_size_differs() {
    check(
        &numbers(&[1, 2, 3, 4]),
        &numbers(&[2, 3, 4, 5]),
        &expect![[r#"
        main  main/main.pjx
          Data
            ~ n  1 → 2
            ~ n[1]  2 → 3
            ~ n[2]  3 → 4
            ~ n[3]  4 → 5

        1 application differs: 4 values
    "#]],
    );
    check(
        &numbers(&[1, 2, 3, 4]),
        &numbers(&[1, 3, 4]),
        &expect![[r#"
        main  main/main.pjx
          Data
            ~ n  size 4 → 3
            - n[1]  removed, the 2 after it moved up by one
                2
                programs address elements by index: 3 indexes differ

        1 application differs: 1 value
    "#]],
    );
    // The last element.
    check(
        &numbers(&[1, 2, 3, 4]),
        &numbers(&[1, 2, 3]),
        &expect![[r#"
        main  main/main.pjx
          Data
            ~ n  size 4 → 3
            - n[3]  = 4

        1 application differs: 1 value
    "#]],
    );
}

fn points_in_frame(x: i32, places: &[String]) -> String {
    points(places).replace("world[0]", "f[0]").replace(
        "<Datas>",
        &format!(
            "<Datas><Data name=\"f\" access=\"private\" xsi:type=\"array\" type=\"frame\" size=\"1\">\
             <Value key=\"0\" x=\"{x}\" fatherId=\"world[0]\"/></Data>"
        ),
    )
}

#[test]
fn points_of_a_renumbered_array_still_move_with_their_frame() {
    let old = row(10);
    check(
        &points_in_frame(0, &old),
        &points_in_frame(5, &old[1..]),
        &expect![[r#"
        main  main/main.pjx
          Points, frames and tools
            ~ p  size 10 → 9
            - p[0]  removed, the 9 after it moved up by one
                x 100, father f
                programs address elements by index: 10 indexes differ, by up to 105.171 mm
              Position     Moved  Turned  In world  Values
            ~ f         5.000 mm          5.000 mm  x 0 → 5
            ~ f  9 positions move with it
                p[0–8]  5.000 mm

        1 application differs: 2 positions, 9 positions that moved along
    "#]],
    );
}

/// Returns 10,000 places that differ; `offset` is added to each `y`.
fn places(offset: f64) -> Vec<String> {
    let places =
        (0..10_000).map(|index| format!("x=\"{}\" y=\"{}\" rz=\"{}\"", 10 * index, 0.1 * 3.0 + offset, index % 90));
    places.collect()
}

#[test]
fn elements_that_moved_by_the_same_amount_share_a_line() {
    let mut new = places(1.5);
    new[7] = "x=\"75\" rz=\"9\"".to_owned();
    check(
        &points(&places(0.0)),
        &points(&new),
        &expect![[r#"
        main  main/main.pjx
          Points, frames and tools
              Position           Moved  Turned          In world  Values
            ~ p[7]            5.009 mm  2.000°  5.009 mm, 2.000°  x 70 → 75, y 0.30000000000000004 → 0, rz 7 → 9
            ~ p[0–6, 8–9999]  1.500 mm                  1.500 mm  each y +1.5

        1 application differs: 10000 positions
    "#]],
    );
    let turned = |rz: f64| (0..3).map(|index| format!("x=\"{index}\" rz=\"{rz}\"")).collect::<Vec<_>>();
    check(
        &points(&turned(0.0)),
        &points(&turned(90.0)),
        &expect![[r#"
        main  main/main.pjx
          Points, frames and tools
              Position  Moved   Turned  In world  Values
            ~ p[0–2]           90.000°   90.000°  each +90° about z

        1 application differs: 3 positions
    "#]],
    );
}

#[test]
fn equal_changes_of_three_numbers_share_a_line() {
    check(
        &numbers(&[0, 0, 0, 7]),
        &numbers(&[1, 1, 1, 8]),
        &expect![[r#"
        main  main/main.pjx
          Data
            ~ n[0–2]  0 → 1
            ~ n[3]  7 → 8

        1 application differs: 4 values
    "#]],
    );
    check(
        &numbers(&[0, 0, 7]),
        &numbers(&[1, 1, 8]),
        &expect![[r#"
        main  main/main.pjx
          Data
            ~ n  0 → 1
            ~ n[1]  0 → 1
            ~ n[2]  7 → 8

        1 application differs: 3 values
    "#]],
    );
}

#[test]
fn a_large_array_without_a_common_element_is_compared_in_linear_time() {
    let all = |offset: usize| (0..20_000).map(|index| format!("x=\"{}\"", index + offset)).collect::<Vec<_>>();
    let report = human(&compared(&points(&all(0)), &points(&all(500_000))));
    assert!(report.contains("p[0–19999]") && report.lines().count() < 10, "{report}");
}
