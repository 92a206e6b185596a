//! Stages of moves, and the ends of their blends.

use super::*;
use crate::{BlendCorner, MoveEvent, MoveEventKind, PathShape, Shortening};

/// Runs a motion and lists its move events as `serial kind`.
fn steps(motion: &mut Motion) -> String {
    let steps = timed(motion);
    steps.iter().map(|step| format!("{} {:?}", step.serial, step.kind)).collect::<Vec<_>>().join(", ")
}

#[test]
fn moves_are_accounted_for_step_by_step() {
    let blend = Blend::Joint { leave: Millimetres(50.0), reach: Millimetres(50.0) };
    let mut motion = motion();
    for (number, (y, blend)) in [(200.0, blend), (200.0, Blend::Off), (0.0, Blend::Off)].into_iter().enumerate() {
        let z = if number == 0 { 0.0 } else { 100.0 };
        motion.record(&request(line(moved(0.0, y, z)), fast(), blend, 5.0)).unwrap();
    }
    let corners: Vec<_> = motion.moves().map(|queued| (queued.leave, queued.reach)).collect();
    let (leave, reach) = (corners[0].0.unwrap(), corners[0].1.unwrap());
    for (corner, expected) in [(leave, moved(0.0, 150.0, 0.0)), (reach, moved(0.0, 200.0, 50.0))] {
        assert!((corner.position - expected.translation.vector).norm() < 1e-9, "{corner:?}");
        assert_eq!(corner.distance, Millimetres(50.0));
    }
    assert_eq!(corners[1..], [(None, None), (None, None)]);
    assert_eq!(steps(&mut motion), "0 Started, 0 Blend, 0 Reached, 0 Done, 1 Started, 1 Done, 2 Started, 2 Done");
    assert_eq!(motion.moves().len(), 0);
}

#[test]
fn a_move_to_where_the_arm_is_is_done_at_once() {
    let mut motion = motion();
    motion.record(&request(MovePath::Joint(START), fast(), Blend::Off, 0.0)).unwrap();
    assert_eq!(steps(&mut motion), "0 Started, 0 Done");
}

/// Runs to the end. Returns the move events, with times since the start.
fn timed(motion: &mut Motion) -> Vec<MoveEvent> {
    let mut steps = Vec::new();
    for cycle in 0..10_000 {
        motion.advance(CYCLE);
        let start = f64::from(cycle) * CYCLE.0;
        steps.extend(motion.take_events().into_iter().map(|step| MoveEvent { at: Seconds(start + step.at.0), ..step }));
        if motion.is_empty() {
            break;
        }
    }
    steps
}

#[test]
fn times_are_those_of_the_plan() {
    let mut motion = motion();
    corner(&mut motion, |leave, reach| Blend::Cartesian { leave, reach }, fast());
    let expected = motion.time_left().0;
    let leave = motion.moves().next().unwrap().leave.unwrap();
    let mut exact = motion.clone();
    let steps = timed(&mut motion);
    assert!(steps.windows(2).all(|pair| pair[0].at <= pair[1].at), "{steps:?}");
    let end = steps.last().unwrap();
    assert!(end.kind == MoveEventKind::Done && (end.at.0 - expected).abs() < 1e-9, "{end:?} instead of {expected}");
    let blend = steps.iter().find(|step| step.kind == MoveEventKind::Blend).unwrap();
    let sample = exact.advance(blend.at);
    assert!((sample.pose.translation.vector - leave.position).norm() < 1e-6);
}

#[test]
fn blend_points_are_at_their_effective_distances() {
    let mut motion = motion();
    let blend = Blend::Cartesian { leave: Millimetres(150.0), reach: Millimetres(150.0) };
    motion.record(&request(line(moved(0.0, 200.0, 0.0)), fast(), blend, 7.0)).unwrap();
    assert!(motion.moves().all(|queued| queued.reach.is_none()));
    motion.record(&request(line(moved(0.0, 200.0, 100.0)), fast(), blend, 8.0)).unwrap();
    motion.record(&request(line(moved(0.0, 0.0, 100.0)), fast(), Blend::Off, 9.0)).unwrap();
    let distance = |corner: Option<BlendCorner>| corner.map(|corner| (corner.distance.0 * 1e9).round() / 1e9);
    let distances: Vec<_> = motion.moves().map(|queued| [distance(queued.leave), distance(queued.reach)]).collect();
    assert_eq!(distances, [[Some(150.0), Some(50.0)], [Some(50.0), Some(150.0)], [None, None]]);
    for queued in motion.moves() {
        assert_eq!((queued.shape, queued.id), (PathShape::Line, 7.0 + queued.serial as f64));
        for corner in [queued.leave, queued.reach].into_iter().flatten() {
            let distance = (corner.position - queued.target.translation.vector).norm();
            assert!((distance - corner.distance.0).abs() < 1e-9, "{queued:?}");
        }
    }
}

/// Leave and reach per move: requested and effective distance, and the reason for a shorter distance.
type Ends = [Option<(f64, f64, Option<Shortening>)>; 2];

/// Executes moves from (0, 0) to each position, in mm, with leave and reach.
fn ends(moves: &[([f64; 2], [f64; 2])]) -> Vec<Ends> {
    let mut motion = motion();
    for ([y, z], distances) in moves {
        let [leave, reach] = distances.map(Millimetres);
        motion.record(&request(line(moved(0.0, *y, *z)), fast(), Blend::Joint { leave, reach }, 0.0)).unwrap();
    }
    let end = |corner: BlendCorner| (corner.requested.0, corner.effective().0.round(), corner.shortening);
    motion.moves().map(|queued| [queued.leave, queued.reach].map(|corner| corner.map(end))).collect()
}

#[test]
fn a_shortened_blend_has_its_reason() {
    use Shortening::{SharedWithNext, SharedWithPrevious, ShortMove, StopAtCorner};
    let shared = ends(&[([100.0, 0.0], [30.0, 30.0]), ([100.0, 40.0], [30.0, 30.0])]);
    assert_eq!(shared[0], [Some((30.0, 30.0, None)), Some((30.0, 20.0, Some(SharedWithNext(1))))]);
    assert_eq!(shared[1], [Some((30.0, 20.0, Some(SharedWithPrevious(0)))), None]);
    let short = ends(&[([20.0, 0.0], [30.0, 30.0]), ([20.0, 10.0], [0.0, 0.0])]);
    assert_eq!(short[0], [Some((30.0, 20.0, Some(ShortMove(0)))), Some((30.0, 10.0, Some(ShortMove(1))))]);
    let stopped = ends(&[([100.0, 0.0], [30.0, 0.0]), ([100.0, 100.0], [0.0, 30.0]), ([0.0, 100.0], [0.0, 0.0])]);
    assert_eq!(stopped[0], [Some((30.0, 0.0, Some(StopAtCorner))), Some((0.0, 0.0, None))]);
    assert_eq!(stopped[1], [Some((0.0, 0.0, None)), Some((30.0, 0.0, Some(StopAtCorner)))]);
    let exact = ends(&[([100.0, 0.0], [50.0, 50.0]), ([100.0, 100.0], [50.0, 50.0])]);
    assert_eq!(exact[0], [Some((50.0, 50.0, None)); 2]);
}

#[test]
fn a_closed_move_is_done_at_its_target() {
    let mut motion = motion();
    let blend = Blend::Joint { leave: Millimetres(50.0), reach: Millimetres(50.0) };
    motion.record(&request(line(moved(0.0, 200.0, 0.0)), fast(), blend, 0.0)).unwrap();
    motion.record(&request(line(moved(0.0, 200.0, 0.0)), fast(), Blend::Off, 1.0)).unwrap();
    wait(&mut motion, 300);
    motion.close().unwrap();
    let cancelled: Vec<_> = motion.moves().map(|queued| (queued.leave, queued.cancelled)).collect();
    assert_eq!(cancelled, [(None, Some([Millimetres(50.0); 2])), (None, None)]);
    assert_eq!(steps(&mut motion), "0 Started, 0 Done, 1 Started, 1 Done");
}

#[test]
fn a_move_to_the_same_place_does_not_break_the_corner_before_it() {
    let mut motion = motion();
    for (target, id) in [(100.0, 0.0), (100.0, 1.0), (0.0, 2.0)] {
        let blend = Blend::Joint { leave: Millimetres(20.0), reach: Millimetres(20.0) };
        motion.record(&request(line(moved(0.0, target, 0.0)), fast(), blend, id)).unwrap();
    }
    let corners: Vec<_> = motion.moves().map(|queued| [queued.leave.is_some(), queued.reach.is_some()]).collect();
    assert_eq!(corners, [[true, true], [false, false], [true, false]]);
    motion.close().unwrap();
    let expected = "0 Started, 0 Blend, 0 Reached, 0 Done, 1 Started, 1 Done, 2 Started, 2 Done";
    assert_eq!(steps(&mut motion), expected);
}
