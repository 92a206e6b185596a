//! Distances between points and paths.

use val3_geometry::Trsf;

use super::*;
use crate::testing::{at, line};

const TOLERANCES: Tolerances = Tolerances { mm: 0.5, degrees: 0.5, time: 5.0 };

fn from_path(place: &TraceRow, path: &[TraceRow]) -> Distance {
    distance(place, path, &TOLERANCES).unwrap()
}

#[track_caller]
fn check(place: &TraceRow, path: &[TraceRow], mm: f64, degrees: f64, joints: f64) {
    let found = from_path(place, path);
    let near = |value: f64, expected: f64| (value - expected).abs() < 1e-5;
    assert!(near(found.mm, mm) && near(found.degrees, degrees), "{found:?}");
    assert!((found.joints - joints).abs() < 0.01, "{found:?}");
}

/// Returns a row of the line between two cycles.
fn between(share: f64) -> TraceRow {
    let mut row = line(1)[0];
    row.pose.translation.vector.x = share;
    row.joints[0] = share;
    row
}

#[test]
fn a_place_on_the_path_has_no_distance() {
    let path = line(9);
    for share in [0.0, 0.3, 4.0, 7.999, 8.0] {
        check(&between(share), &path, 0.0, 0.0, 0.0);
        check(&between(share), &[path[0], path[8]], 0.0, 0.0, 0.0);
    }
}

#[test]
fn beyond_the_ends_the_distance_is_that_to_the_end() {
    let path = line(9);
    check(&between(-0.5), &path, 0.5, 0.0, 0.5);
    check(&between(9.25), &path, 1.25, 0.0, 1.25);
    check(&between(3.0), &path[..1], 3.0, 0.0, 3.0);
    assert_eq!(from_path(&between(9.25), &path).nearest, Vector3::new(8.0, 0.0, 0.0));
    assert_eq!(distance(&between(0.0), &[], &TOLERANCES), None);
}

#[test]
fn displacement_and_rotation_are_measured_apart() {
    let (path, place) = (line(9), between(3.3));
    check(&at(&place, [0.0, 3.0, 4.0], [0.0; 3]), &path, 5.0, 0.0, 0.0);
    check(&at(&place, [0.0; 3], [0.0, 0.0, 2.0]), &path, 0.0, 2.0, 0.0);
    check(&at(&place, [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]), &path, 1.0, 1.0, 0.0);
    let found = from_path(&at(&place, [0.0, 0.0, 4.0], [0.0; 3]), &path);
    assert!((found.nearest - Vector3::new(3.3, 0.0, 0.0)).amax() < 1e-9, "{found:?}");
}

/// The tool turns around its centre point, so that only the angle determines the point of the path.
#[test]
fn a_pure_rotation_is_a_path() {
    let turned = |angle: f64| TraceRow { joints: [0.0, 0.0, 0.0, angle, 0.0, 0.0], ..place(7.0, angle) };
    let path = [turned(-30.0), turned(50.0)];
    check(&turned(12.0), &path, 0.0, 0.0, 0.0);
    check(&turned(53.0), &path, 0.0, 3.0, 3.0);
    check(&at(&turned(12.0), [0.0; 3], [0.0, 2.0, 0.0]), &path, 0.0, 2.0, 0.0);
}

/// Position and rotation change together, and both determine the point of the path.
#[test]
fn tolerances_weigh_the_same() {
    let path = [place(0.0, 0.0), place(10.0, 10.0)];
    // With equal tolerances, the nearest point is halfway between x = 4 and rx = 6.
    let found = from_path(&place(4.0, 6.0), &path);
    assert!((found.nearest.x - 5.0).abs() < 1e-9 && (found.mm - 1.0).abs() < 1e-9, "{found:?}");
    let narrow = Tolerances { mm: 0.1, ..TOLERANCES };
    let found = distance(&place(4.0, 6.0), &path, &narrow).unwrap();
    // 25 times the weight: (25 * 4 + 6) / 26.
    assert!((found.nearest.x - 106.0 / 26.0).abs() < 1e-9, "{found:?}");
    let wide = Tolerances { degrees: 0.1, ..TOLERANCES };
    let found = distance(&place(4.0, 6.0), &path, &wide).unwrap();
    assert!((found.nearest.x - 154.0 / 26.0).abs() < 1e-9, "{found:?}");
}

/// Returns a row at x, turned around the x axis.
fn place(x: f64, angle: f64) -> TraceRow {
    let pose = Trsf::new([x, 0.0, 0.0], [angle, 0.0, 0.0]).isometry();
    TraceRow { pose, joints: [0.0; 6], ..line(1)[0] }
}

/// A path that returns to a pose with another turn of axis 6.
#[test]
fn of_two_places_with_one_pose_the_nearer_joints_count() {
    let turned = |turn: f64| TraceRow { joints: [0.0, 0.0, 0.0, 0.0, 0.0, turn], ..line(1)[0] };
    let path = [turned(0.0), turned(90.0), turned(180.0), turned(270.0), turned(360.0)];
    check(&turned(360.0), &path, 0.0, 0.0, 0.0);
    check(&turned(200.0), &path, 0.0, 0.0, 0.0);
    check(&turned(400.0), &path, 0.0, 0.0, 40.0);
    // Joints are not compared at a point beyond the tolerance.
    let elsewhere = at(&turned(400.0), [3.0, 0.0, 0.0], [0.0; 3]);
    let moved: Vec<TraceRow> =
        path.iter().enumerate().map(|(step, row)| at(row, [-(step as f64), 0.0, 0.0], [0.0; 3])).collect();
    assert_eq!(from_path(&elsewhere, &moved).mm, 3.0);
}

/// If two points are equally near, the first is selected.
#[test]
fn equal_distances_do_not_change_the_place() {
    let place = |y: f64| at(&TraceRow { joints: [0.0; 6], ..line(1)[0] }, [0.0, y, 0.0], [0.0; 3]);
    let found = from_path(&place(0.0), &[place(4.0), place(4.0), place(-4.0), place(-4.0)]);
    assert_eq!(found.mm, 0.0);
    let far = |x: f64, y: f64| at(&place(y), [x, 0.0, 0.0], [0.0; 3]);
    let found =
        from_path(&far(0.0, 0.0), &[far(0.0, 4.0), far(4.0, 4.0), far(8.0, 0.0), far(4.0, -4.0), far(0.0, -4.0)]);
    assert_eq!((found.mm, found.nearest.y), (4.0, 4.0));
}

#[test]
fn what_is_exactly_at_the_tolerance_is_within_it() {
    let distance = |mm, degrees, joints| Distance { mm, degrees, joints, nearest: Vector3::zeros() };
    let excess = |mm, degrees, joints| distance(mm, degrees, joints).excess(&TOLERANCES);
    assert_eq!([excess(0.5, 0.25, 0.0), excess(0.25, 0.5, 0.0), excess(0.0, 0.0, 10.0)], [1.0; 3]);
    assert_eq!([excess(1.5, 0.5, 90.0), excess(0.5, 1.5, 90.0), excess(0.5, 0.5, 90.0)], [3.0, 3.0, 9.0]);
}
