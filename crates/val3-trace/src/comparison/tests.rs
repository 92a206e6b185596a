//! Comparisons of small traces.

use proptest::prelude::*;
use val3_geometry::Trsf;
use val3_motion::MotionPhase;

use super::*;
use crate::testing::{at, line, trace};

const TOLERANCES: Tolerances = Tolerances { mm: 0.5, degrees: 0.5, time: 5.0 };

fn compared(recorded: &[TraceRow], present: &[TraceRow]) -> Comparison {
    compare(recorded, present, TOLERANCES)
}

/// Moves a range of rows in world.
fn moved(rows: &[TraceRow], part: Range<usize>, way: [f64; 3]) -> Vec<TraceRow> {
    let row = |(place, row): (usize, &TraceRow)| if part.contains(&place) { at(row, way, [0.0; 3]) } else { *row };
    rows.iter().enumerate().map(row).collect()
}

/// Returns rows from 0 to `length` on the line, at a speed in mm for each cycle, with the ids of the points.
fn at_speed(speed: f64, length: f64) -> Vec<TraceRow> {
    let count = (length / speed).ceil() as u64;
    (0..=count).map(|cycle| row_at(cycle, (cycle as f64 * speed).min(length))).collect()
}

fn row_at(cycle: u64, x: f64) -> TraceRow {
    TraceRow {
        time: 1_000_000_000 + cycle * 4_000_000,
        id: 1.0 + (x / 10.0).max(0.001),
        pose: Trsf::new([x, 0.0, 0.0], [0.0; 3]).isometry(),
        joints: [x, 0.0, 0.0, 0.0, 0.0, 0.0],
        ..line(1)[0]
    }
}

#[test]
fn a_trace_equals_itself() {
    let rows = line(35);
    let same = compared(&rows, &rows);
    assert!(same.is_same() && same.first().is_none() && !same.takes_other_time());
    assert_eq!(same.moves.iter().map(|one| one.number).collect::<Vec<_>>(), [1, 2, 3, 4]);
    assert_eq!((same.counts(), same.largest().unwrap().1.excess), ([4, 4], 0.0));
    assert!(compared(&[], &[]).is_same());
}

#[test]
fn a_displaced_piece_is_reported_with_its_displacement() {
    let rows = line(35);
    let found = compared(&rows, &moved(&rows, 14..17, [0.0, 3.0, 4.0]));
    let first = found.first().unwrap();
    let deviation = first.deviation.unwrap();
    assert_eq!(
        (first.number, first.rows.clone(), deviation.side, deviation.time),
        (2, 11..21, TraceSide::Present, 56_000_000)
    );
    assert_eq!((deviation.distance.mm, deviation.at), (5.0, Vector3::new(14.0, 3.0, 4.0)));
    assert_eq!(deviation.distance.nearest, Vector3::new(14.0, 0.0, 0.0));
    assert!(!found.is_same() && !found.takes_other_time() && found.slower_or_faster().next().is_none());
    let largest = found.largest().unwrap();
    assert_eq!((largest.0.number, largest.1), (2, deviation));
}

#[test]
fn the_first_move_and_the_largest_deviation_may_differ() {
    let rows = line(35);
    let present = moved(&moved(&rows, 5..6, [0.0, 0.0, 1.0]), 25..26, [0.0, 0.0, 2.0]);
    let found = compared(&rows, &present);
    assert_eq!(found.moves.iter().map(MoveComparison::diverges).collect::<Vec<_>>(), [true, false, true, false]);
    assert_eq!(found.first().unwrap().number, 1);
    let (largest, deviation) = found.largest().unwrap();
    assert_eq!((largest.number, deviation.distance.mm, deviation.excess), (3, 2.0, 4.0));
    // The first of two equal deviations.
    let present = moved(&moved(&rows, 5..6, [0.0, 0.0, 1.0]), 25..26, [0.0, 0.0, 1.0]);
    assert_eq!(compared(&rows, &present).largest().unwrap().0.number, 1);
}

#[test]
fn a_piece_that_is_missing_is_found_as_well_as_an_additional_one() {
    let rows = line(10);
    let mut detour = rows.clone();
    detour.insert(5, at(&rows[4], [0.0, 0.0, 7.0], [0.0; 3]));
    detour.iter_mut().zip(0..).for_each(|(row, cycle)| row.time = cycle * 4_000_000);
    for (recorded, present, side) in [(&rows, &detour, TraceSide::Present), (&detour, &rows, TraceSide::Recorded)] {
        let deviation = compared(recorded, present).first().unwrap().deviation.unwrap();
        assert_eq!((deviation.side, deviation.distance.mm, deviation.at), (side, 7.0, Vector3::new(4.0, 0.0, 7.0)));
        assert_eq!(deviation.time, 20_000_000);
    }
}

#[test]
fn what_is_exactly_at_a_tolerance_is_the_same() {
    assert!(is_same(&|row| at(row, [0.0, 0.5, 0.0], [0.0; 3])));
    assert!(!is_same(&|row| at(row, [0.0, 0.500_001, 0.0], [0.0; 3])));
    assert!(is_same(&|row| at(row, [0.0; 3], [0.0, 0.499_999, 0.0])));
    assert!(!is_same(&|row| at(row, [0.0; 3], [0.0, 0.500_001, 0.0])));
    assert!(is_same(&|row| other_joints(row, -10.0)));
    assert!(!is_same(&|row| other_joints(row, -10.000_001)));
}

/// Whether a trace is the same after a change of its rows.
fn is_same(change: &dyn Fn(&TraceRow) -> TraceRow) -> bool {
    let rows = line(10);
    let present: Vec<TraceRow> = rows.iter().map(change).collect();
    compared(&rows, &present).is_same()
}

fn other_joints(row: &TraceRow, difference: f64) -> TraceRow {
    let mut joints = row.joints;
    joints[3] += difference;
    TraceRow { joints, ..*row }
}

#[test]
fn another_speed_changes_times_alone() {
    let found = compared(&at_speed(1.0, 30.0), &at_speed(0.3, 30.0));
    assert!(found.first().is_none() && found.takes_other_time() && !found.is_same());
    assert!(found.largest().unwrap().1.excess < 1e-6, "{:?}", found.largest());
    let slower: Vec<_> = found.slower_or_faster().map(|(one, times)| (one.number, times)).collect();
    let ms = |ms: Time| ms * 1_000_000;
    assert_eq!(slower, [(1, [ms(44), ms(136)]), (2, [ms(40), ms(132)]), (3, [ms(40), ms(136)])]);
    assert_eq!(found.times.map(|times| times.whole()), [ms(124), ms(404)]);
}

#[test]
fn one_slow_move_is_enough() {
    // The last of 100 moves needs 60 ms instead of 40 ms.
    let rows = line(1001);
    let mut present = rows.clone();
    present.iter_mut().skip(991).zip(1..).for_each(|(row, cycle)| row.time += cycle * 2_000_000);
    let found = compared(&rows, &present);
    assert!(!found.takes_other_time() && !found.is_same() && found.first().is_none());
    assert_eq!(found.slower_or_faster().map(|(one, _)| one.number).collect::<Vec<_>>(), [100]);
}

#[test]
fn a_longer_rest_counts_in_the_whole_time() {
    let rows: Vec<TraceRow> = line(20)
        .into_iter()
        .zip(0..)
        .map(|(row, place)| TraceRow { phase: if place == 10 { MotionPhase::Waiting } else { row.phase }, ..row })
        .collect();
    let mut present = rows.clone();
    present.iter_mut().skip(11).for_each(|row| row.time += 400_000_000);
    let found = compared(&rows, &present);
    assert!(found.takes_other_time() && !found.is_same() && found.slower_or_faster().next().is_none());
    assert_eq!(found.times.map(|times| times.resting / 1_000_000), [4, 404]);
}

#[test]
fn moves_that_one_trace_does_not_have() {
    let rows = line(35);
    let short = &rows[..31];
    let found = compared(&rows, short);
    let last = found.moves.last().unwrap();
    assert_eq!(
        (found.counts(), found.first().unwrap().number, last.is_missing(), last.is_additional()),
        ([4, 3], 4, true, false)
    );
    assert_eq!((last.moving(), last.rows.clone()), (None, 31..31));
    assert_eq!((last.deviation.unwrap().side, last.deviation.unwrap().distance.mm), (TraceSide::Recorded, 4.0));
    let found = compared(short, &rows);
    let last = found.moves.last().unwrap();
    assert_eq!((found.counts(), last.is_missing(), last.is_additional()), ([3, 4], false, true));
    assert_eq!((last.deviation.unwrap().side, last.rows.clone()), (TraceSide::Present, 31..35));
}

#[test]
fn no_motion_at_all() {
    let rows = line(15);
    let found = compared(&rows, &[]);
    assert_eq!((found.is_same(), found.counts(), found.first().unwrap().number), (false, [2, 0], 1));
    assert!(found.moves.iter().all(|one| one.is_missing() && one.deviation.is_none()));
    let found = compared(&[], &rows);
    assert_eq!((found.is_same(), found.counts(), found.first().unwrap().number), (false, [0, 2], 1));
    assert!(found.moves.iter().all(MoveComparison::is_additional) && found.largest().is_none());
}

/// A move with one or two cycles may lie between two rows of a faster trace.
#[test]
fn a_move_without_a_row_is_no_difference() {
    let mut rows = line(21);
    rows.iter_mut().for_each(|row| row.pose.translation.vector.x /= 10.0);
    rows.iter_mut().skip(11).for_each(|row| row.id += 1.0);
    let mut present = rows.clone();
    present[11].id = 2.5;
    assert!(compared(&rows, &present).is_same() && compared(&present, &rows).is_same());
    // At most two cycles.
    present[12].id = 2.6;
    assert!(compared(&rows, &present).is_same() && compared(&present, &rows).is_same());
    present[13].id = 2.7;
    let found = compared(&rows, &present);
    assert!(!found.is_same() && found.moves[1].is_additional() && found.first().unwrap().number == 2);
    let found = compared(&present, &rows);
    assert!(!found.is_same() && found.moves[1].is_missing() && found.first().unwrap().number == 2);
    // At another place it is a difference.
    let mut present = rows.clone();
    present[11] = TraceRow { id: 2.5, ..at(&rows[11], [0.0, 1.0, 0.0], [0.0; 3]) };
    let found = compared(&rows, &present);
    assert!(!found.is_same() && found.first().unwrap().deviation.unwrap().distance.mm == 1.0);
}

proptest! {
    #[test]
    fn any_speed_of_one_path_differs_in_times_alone(speed in 0.05..2.0_f64, other in 0.05..2.0_f64) {
        let found = compared(&at_speed(speed, 40.0), &at_speed(other, 40.0));
        prop_assert!(found.first().is_none());
        prop_assert!(found.largest().unwrap().1.excess < 1e-6);
    }

    #[test]
    fn both_directions_find_the_same_distance(
        way in [-20.0..20.0_f64, -20.0..20.0, -20.0..20.0],
        turn in [-5.0..5.0_f64, -5.0..5.0, -5.0..5.0],
        from in 0..30_usize,
        length in 1..10_usize,
    ) {
        let rows = line(40);
        let present: Vec<TraceRow> = rows
            .iter()
            .enumerate()
            .map(|(place, row)| if (from..from + length).contains(&place) { at(row, way, turn) } else { *row })
            .collect();
        let (there, back) = (compared(&rows, &present), compared(&present, &rows));
        prop_assert_eq!(there.is_same(), back.is_same());
        for (one, other) in there.moves.iter().zip(&back.moves) {
            prop_assert_eq!(one.diverges(), other.diverges());
            let (one, other) = (one.deviation.unwrap(), other.deviation.unwrap());
            prop_assert!((one.excess - other.excess).abs() < 1e-9);
        }
    }

    #[test]
    fn thinned_rows_are_the_same_motion(speed in 0.2..2.0_f64, bend in 0.0..10.0_f64) {
        let curved = |row: &TraceRow| at(row, [0.0, bend * sine(row.position().x / 5.0), 0.0], [0.0; 3]);
        let rows: Vec<TraceRow> = at_speed(speed, 40.0).iter().map(curved).collect();
        let thin = trace(&rows).thinned();
        let read = crate::row::Trace::parse(&thin.to_text()).unwrap();
        let found = compare(&read.rows, &rows, Tolerances { mm: 0.052, degrees: 0.052, time: 0.001 });
        prop_assert!(found.is_same(), "{:?}", found.largest());
        prop_assert_eq!(TraceTimes::of(&thin.rows, 0..thin.rows.len()), TraceTimes::of(&rows, 0..rows.len()));
    }
}

fn sine(value: f64) -> f64 {
    val3_geometry::degrees::sin(value.to_degrees())
}
