//! Limits of small traces.

use val3_geometry::IsometryMatrix3;
use val3_motion::MotionPhase;

use super::*;
use crate::testing::{at, line};

fn zone(min: [f64; 3], max: [f64; 3]) -> Zone {
    Zone::new(min, max, &IsometryMatrix3::identity())
}

fn violation(limit: Limit, rows: &[TraceRow]) -> Option<Violation> {
    limit.violation(rows, 0..rows.len())
}

/// Returns the line with steps of 8 mm, at 2 m/s.
fn fast() -> Vec<TraceRow> {
    let row = |row: &TraceRow| TraceRow { speed: 2000.0, ..at(row, [7.0 * row.position().x, 0.0, 0.0], [0.0; 3]) };
    line(10).iter().map(row).collect()
}

#[test]
fn a_speed_everywhere() {
    let mut rows = line(10);
    (rows[4].speed, rows[6].speed, rows[7].speed) = (260.0, 270.0, 270.0);
    let found = violation(Limit::Speed { most: 250.0, zone: None }, &rows).unwrap();
    assert_eq!((found.value, found.row, found.time, found.at), (270.0, 6, 24_000_000, Vector3::new(6.0, 0.0, 0.0)));
    assert_eq!(violation(Limit::Speed { most: 270.0, zone: None }, &rows), None);
    assert_eq!(violation(Limit::Speed { most: 269.9995, zone: None }, &rows), None);
    assert!(violation(Limit::Speed { most: 269.998, zone: None }, &rows).is_some());
}

#[test]
fn a_part_of_the_run() {
    let mut rows = line(10);
    rows[4].speed = 260.0;
    let limit = Limit::Speed { most: 250.0, zone: None };
    assert_eq!([limit.violation(&rows, 5..10), limit.violation(&rows, 0..4)], [None; 2]);
    assert!(limit.violation(&rows, 4..5).is_some() && limit.violation(&rows, 4..50).is_some());
}

#[test]
fn a_speed_in_a_box_that_the_arm_crosses_between_two_rows() {
    let limit = |from: f64, to: f64| Limit::Speed { most: 250.0, zone: Some(zone([from, -1.0, -1.0], [to, 1.0, 1.0])) };
    // Rows are at 8, 16 and so on.
    let found = violation(limit(18.0, 20.0), &fast()).unwrap();
    assert_eq!((found.value, found.row, found.at), (2000.0, 3, Vector3::new(18.0, 0.0, 0.0)));
    assert_eq!(violation(limit(80.0, 90.0), &fast()), None);
    let aside = zone([18.0, 1.0, -1.0], [20.0, 2.0, 1.0]);
    assert_eq!(violation(Limit::Speed { most: 250.0, zone: Some(aside) }, &fast()), None);
    let touching =
        |distance: f64| Limit::Speed { most: 250.0, zone: Some(zone([0.0, distance, -1.0], [100.0, 2.0, 1.0])) };
    assert!(violation(touching(0.0005), &fast()).is_some() && violation(touching(0.001), &fast()).is_none());
}

#[test]
fn never_outside_of_a_box() {
    let rows = line(10);
    let inside = |to: f64| violation(Limit::Inside(zone([0.0, -1.0, 0.0], [to, 0.0, 0.0])), &rows);
    assert_eq!([inside(9.0), inside(8.9995)], [None; 2]);
    let found = inside(6.5).unwrap();
    assert_eq!((found.value, found.row, found.at), (2.5, 9, Vector3::new(9.0, 0.0, 0.0)));
}

#[test]
fn a_distance_to_a_box_between_two_rows() {
    let clear = |least: f64| Limit::Clear { zone: zone([18.0, 3.0, 0.0], [18.0, 3.0, 0.0]), least };
    let found = violation(clear(5.0), &fast()).unwrap();
    assert_eq!((found.value, found.row, found.at), (3.0, 3, Vector3::new(18.0, 0.0, 0.0)));
    assert_eq!([violation(clear(3.0), &fast()), violation(clear(3.0005), &fast())], [None; 2]);
    assert!(violation(clear(3.002), &fast()).is_some());
    let inside = Limit::Clear { zone: zone([0.0, 0.0, 0.0], [90.0, 1.0, 1.0]), least: 0.001 };
    assert_eq!(violation(inside, &fast()), None);
    // The first of several equally near points.
    let within = zone([10.0, -1.0, -1.0], [40.0, 1.0, 1.0]);
    let found = violation(Limit::Clear { zone: within, least: 5.0 }, &fast()).unwrap();
    assert_eq!((found.value, found.row, found.at.x), (0.0, 2, 10.0));
}

/// The tool was exchanged, or the arm was placed elsewhere: there is no path between the two rows.
#[test]
fn a_jump_is_no_way() {
    let mut rows = line(6);
    rows[3..].iter_mut().for_each(|row| row.pose.translation.vector.z += 100.0);
    let clear = Limit::Clear { zone: zone([0.0, -1.0, 45.0], [10.0, 1.0, 55.0]), least: 1.0 };
    assert_eq!(violation(clear, &rows), None);
    // A path of 100 mm in a cycle means 25 m/s.
    let mut fast = rows;
    fast[3].speed = 25_005.0;
    assert_eq!(violation(clear, &fast).unwrap().row, 3);
    fast[3].speed = 24_000.0;
    assert_eq!(violation(clear, &fast), None);
}

#[test]
fn rows_at_rest_have_no_speed() {
    let mut rows = line(3);
    rows[2] = TraceRow { phase: MotionPhase::Waiting, speed: 0.0, pose: rows[1].pose, ..rows[2] };
    let clear = Limit::Clear { zone: zone([1.0, 0.0, 0.0], [1.0, 0.0, 0.0]), least: 1.0 };
    assert_eq!(violation(clear, &rows[1..]).map(|found| (found.value, found.row)), Some((0.0, 0)));
    assert_eq!(violation(clear, &[]), None);
}
