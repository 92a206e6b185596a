//! Step mode: the positions are bit-identical to the continuous mode, and the arm waits at the ends of pieces.

use proptest::prelude::*;
use val3_geometry::Vector3;

use super::distances::{Distances, distance_from_corner, effective_distances, length};
use super::path_independence::{self, reference, requests};
use super::*;
use crate::{AlterReference, AlterStatus, ExternalForce, MotionMode, MoveEventKind, PathPiece, PieceEnd, PieceKind};

fn stepping() -> Motion {
    let mut motion = motion();
    motion.set_mode(MotionMode::Step);
    motion
}

fn joint_blend(leave: f64, reach: f64) -> Blend {
    Blend::Joint { leave: Millimetres(leave), reach: Millimetres(reach) }
}

fn cartesian_blend(leave: f64, reach: f64) -> Blend {
    Blend::Cartesian { leave: Millimetres(leave), reach: Millimetres(reach) }
}

/// Three moves around a U, from manual 10.1.2.
fn u_cycle(blend: Blend) -> Vec<Move> {
    let corners = [(0.0, 0.0, -150.0), (0.0, 200.0, -150.0), (0.0, 200.0, 0.0)];
    let requests = corners.into_iter().zip([0.0, 1.0, 2.0]);
    requests.map(|((x, y, z), id)| request(line(moved(x, y, z)), fast(), blend, id)).collect()
}

/// Four moves from manual 10.2.2.
fn four_joint_moves(blend: Blend) -> Vec<Move> {
    let targets = [[30.0, 10.0], [40.0, -10.0], [0.0, -20.0], [-30.0, 5.0]];
    let path = |[first, second]: [f64; 2]| MovePath::Joint([first, second, 90.0 - second, 10.0, 90.0, first]);
    targets.into_iter().zip([0.0, 1.0, 2.0, 3.0]).map(|(to, id)| request(path(to), fast(), blend, id)).collect()
}

/// Runs until the arm has arrived. Each position must be bit-identical to the reference at the same point of the path.
#[track_caller]
fn arrive_along(motion: &mut Motion, reference: &Motion) {
    for _ in 0..20_000 {
        motion.advance(CYCLE);
        assert!(is_on(motion, reference), "{:?} at {}", motion.joints(), motion.move_id());
        if motion.has_arrived() {
            return;
        }
    }
    panic!("the arm does not arrive");
}

/// Whether the position is bit-identical to the reference at the same point of the path.
fn is_on(motion: &Motion, reference: &Motion) -> bool {
    let (Some(front), Some(p)) = (motion.timeline.spans.front(), motion.timeline.p()) else { return true };
    let spans = reference.timeline.spans.iter().filter(|other| other.span.part == front.span.part);
    let mut axes = spans.filter(|other| other.span.range() == front.span.range()).map(|other| &other.span);
    axes.any(|span| bits(&span.axes(&Model(&motion.arm), p)) == bits(&motion.axes()))
}

fn bits(axes: &Axes) -> [u64; 6] {
    Joints::from(*axes).map(f64::to_bits)
}

#[track_caller]
fn assert_waits(motion: &mut Motion) {
    let before = motion.joints();
    for _ in 0..50 {
        let sample = motion.advance(CYCLE);
        assert_eq!(sample.joints.map(f64::to_bits), before.map(f64::to_bits));
        assert!(sample.phase == MotionPhase::Waiting && sample.speed.0 == 0.0);
    }
    assert!(!motion.can_go_on() && motion.has_arrived());
}

/// Executes a program move by move, as in manual 10.2.2, and checks the waiting positions.
fn step_by_move(requests: &[Move]) {
    let reference = reference(requests).unwrap();
    let targets: Vec<_> = reference.moves().map(|queued| queued.joints).collect();
    let distances = effective_distances(requests, &targets);
    let mut motion = stepping();
    for (number, request) in requests.iter().enumerate() {
        motion.record(request).unwrap();
        assert_waits(&mut motion);
        motion.release_determined();
        arrive_along(&mut motion, &reference);
        assert_waits(&mut motion);
        let piece = motion.piece().unwrap();
        // If corners meet, a move has no nominal part, and the previous blend ends at its leave point.
        let is_blend_before = piece.kind == PieceKind::Blend && piece.serial + 1 == number as u64;
        assert!(piece.serial == number as u64 || is_blend_before);
        assert_eq!(piece.joints, motion.joints());
        let Distances { effective: [leave, _], is_reduced, .. } = distances[number];
        let halt = PathPiece { serial: number as u64, end: PieceEnd::Leave, ..piece };
        let (distance, tolerance) = distance_from_corner(&halt, requests, &targets, is_reduced[0]);
        assert!((distance - leave).abs() < tolerance, "{distance} instead of {leave}");
        if request.blend.distances().is_some() {
            assert!(!motion.is_empty() && motion.next_piece().is_none());
            // The reference has no leave point after its last move.
            let leave = reference.leave_point(number as u64).filter(|_| number + 1 < requests.len());
            assert!(leave.is_none_or(|(joints, _)| joints == motion.joints()));
        } else {
            assert_eq!((piece.end, motion.joints()), (PieceEnd::Target, targets[number]));
        }
    }
    motion.close().unwrap();
    motion.release_determined();
    arrive_along(&mut motion, &reference);
    assert_eq!(Some(&motion.joints()), targets.last());
    assert!(motion.is_empty());
}

impl Motion {
    fn commanded_tip(&self) -> Vector3<f64> {
        Model(&self.arm).flange(&self.axes()).translation.vector
    }
}

#[test]
fn the_programs_of_the_manual_stop_at_their_leave_points() {
    for (leave, reach) in [(50.0, 50.0), (20.0, 60.0), (120.0, 120.0), (0.0, 40.0), (40.0, 0.0)] {
        for blend in [joint_blend(leave, reach), cartesian_blend(leave, reach)] {
            step_by_move(&u_cycle(blend));
        }
        step_by_move(&four_joint_moves(joint_blend(leave, reach)));
    }
    step_by_move(&four_joint_moves(Blend::Off));
    step_by_move(&u_cycle(Blend::Off));
}

/// Lists the pieces at which the arm waits, with one release per piece.
fn pieces(motion: &mut Motion, reference: &Motion) -> String {
    let mut found = Vec::new();
    while motion.release_piece() {
        arrive_along(motion, reference);
        assert_waits(motion);
        let piece = motion.piece().unwrap();
        assert_eq!(piece.joints, motion.joints());
        match piece.end {
            PieceEnd::Leave => {
                assert_eq!(Some(piece.joints), reference.leave_point(piece.serial).map(|(joints, _)| joints))
            }
            PieceEnd::Reach => {
                assert_eq!(Some(piece.joints), reference.reach_point(piece.serial).map(|(joints, _)| joints))
            }
            PieceEnd::Target | PieceEnd::Fault => {}
        }
        let kind = if piece.kind == PieceKind::Blend { "blend" } else { "nominal" };
        found.push(format!("{} {kind} to {:?}", piece.serial, piece.end));
    }
    found.join(", ")
}

#[test]
fn pieces_are_nominal_parts_and_blends() {
    let requests = four_joint_moves(joint_blend(50.0, 50.0));
    let reference = reference(&requests).unwrap();
    let mut motion = stepping();
    requests.iter().for_each(|request| motion.record(request).unwrap());
    let open = motion.clone();
    let determined: Vec<_> = motion.pieces().map(|piece| (piece.serial, piece.end)).collect();
    assert_eq!(determined.len(), 7);
    assert!(motion.piece().is_none());
    assert_eq!(motion.next_piece().map(|piece| piece.end), Some(PieceEnd::Leave));
    assert_eq!(
        pieces(&mut motion, &open),
        "0 nominal to Leave, 0 blend to Reach, 1 nominal to Leave, 1 blend to Reach, 2 nominal to Leave, 2 blend to Reach, \
         3 nominal to Leave"
    );
    motion.close().unwrap();
    assert_eq!(pieces(&mut motion, &reference), "3 nominal to Target");
    assert!(motion.is_empty() && motion.next_piece().is_none());
}

/// Example from manual 10.2.3: `waitEndMove` after the second of four moves.
#[test]
fn a_closed_corner_ends_a_piece_at_its_target() {
    let requests = four_joint_moves(joint_blend(50.0, 50.0));
    let mut reference = motion();
    let mut motion = stepping();
    for motion in [&mut reference, &mut motion] {
        for (number, request) in requests.iter().enumerate() {
            if number == 2 {
                motion.close().unwrap();
            }
            motion.record(request).unwrap();
        }
        motion.close().unwrap();
    }
    assert_eq!(
        pieces(&mut motion, &reference),
        "0 nominal to Leave, 0 blend to Reach, 1 nominal to Target, 2 nominal to Leave, 2 blend to Reach, 3 nominal to Target"
    );
}

#[test]
fn a_release_to_the_end_passes_all_pieces_as_the_continuous_mode() {
    let requests = u_cycle(cartesian_blend(30.0, 30.0));
    let (mut continuous, mut motion) = (reference(&requests).unwrap(), stepping());
    let reference = continuous.clone();
    requests.iter().for_each(|request| motion.record(request).unwrap());
    motion.close().unwrap();
    motion.release_determined();
    arrive_along(&mut motion, &reference);
    run(&mut continuous, |_, _| ());
    assert_eq!(motion.joints(), continuous.joints());
    assert_eq!(kinds(&mut motion), kinds(&mut continuous));
    // Moves recorded later wait again.
    motion.record(&Move { id: 3.0, ..requests[0].clone() }).unwrap();
    assert_waits(&mut motion);
}

#[test]
fn steps_of_moves_are_those_of_the_continuous_mode() {
    let requests = four_joint_moves(joint_blend(30.0, 30.0));
    let (mut continuous, mut motion) = (reference(&requests).unwrap(), stepping());
    let reference = continuous.clone();
    requests.iter().for_each(|request| motion.record(request).unwrap());
    motion.close().unwrap();
    pieces(&mut motion, &reference);
    run(&mut continuous, |_, _| ());
    assert_eq!(kinds(&mut motion), kinds(&mut continuous));
}

/// Serial numbers and kinds of the events since the last call.
fn kinds(motion: &mut Motion) -> Vec<(u64, MoveEventKind)> {
    motion.take_events().into_iter().map(|step| (step.serial, step.kind)).collect()
}

/// When step mode is set in any cycle of a run, the arm finishes a piece within its axis limits.
#[test]
fn the_mode_changes_in_the_middle_of_a_move() {
    let requests = u_cycle(cartesian_blend(40.0, 40.0));
    let mut continuous = reference(&requests).unwrap();
    let reference = continuous.clone();
    for _ in 0..10_000 {
        if continuous.is_empty() {
            break;
        }
        let mut motion = continuous.clone();
        motion.set_mode(MotionMode::Step);
        let mut before = motion.clone().joints();
        let mut speeds = motion.clone().advance(CYCLE).joints;
        speeds.iter_mut().zip(before).for_each(|(speed, before)| *speed = (*speed - before) / CYCLE.0);
        while !motion.has_arrived() {
            let sample = motion.advance(CYCLE);
            assert!(is_on(&motion, &reference));
            for axis in 0..6 {
                let speed = (sample.joints[axis] - before[axis]) / CYCLE.0;
                let acceleration = (speed - speeds[axis]).abs() / CYCLE.0;
                assert!(acceleration < 1.05 * 5.0 * NOMINAL[axis], "axis {axis}: {acceleration} at {}", sample.id);
                speeds[axis] = speed;
            }
            before = sample.joints;
        }
        assert_eq!(motion.piece().map_or(START, |piece| piece.joints), motion.joints());
        assert_waits(&mut motion);
        motion.set_mode(MotionMode::Continuous);
        assert!(motion.can_go_on() || motion.is_empty());
        while !motion.is_empty() {
            motion.advance(CYCLE);
            assert!(is_on(&motion, &reference));
        }
        continuous.advance(CYCLE);
    }
    assert!(continuous.is_empty());
}

#[test]
fn a_move_to_where_the_arm_is_needs_no_release() {
    let mut motion = stepping();
    motion.record(&request(MovePath::Joint(START), fast(), joint_blend(10.0, 10.0), 0.0)).unwrap();
    motion.advance(CYCLE);
    assert!(motion.is_empty() && motion.move_id() == 1.0 && !motion.release_piece());
}

#[test]
fn stops_and_restarts_keep_the_gates() {
    let requests = u_cycle(cartesian_blend(40.0, 40.0));
    let reference = reference(&requests).unwrap();
    for (hold, free) in
        [(Motion::stop as fn(&mut Motion), Motion::restart as fn(&mut Motion)), (Motion::brake, Motion::resume)]
    {
        for cycles in 0..60 {
            let mut motion = stepping();
            requests.iter().for_each(|request| motion.record(request).unwrap());
            motion.close().unwrap();
            hold(&mut motion);
            wait(&mut motion, 5);
            free(&mut motion);
            assert_waits(&mut motion);
            motion.release_piece();
            wait(&mut motion, cycles);
            hold(&mut motion);
            wait(&mut motion, 60);
            assert!(is_on(&motion, &reference) && !motion.is_moving());
            free(&mut motion);
            arrive_along(&mut motion, &reference);
            let piece = motion.piece().unwrap();
            assert_eq!((piece.serial, piece.end, piece.joints), (0, PieceEnd::Leave, motion.joints()));
            assert_waits(&mut motion);
            assert!(pieces(&mut motion, &reference).ends_with("2 nominal to Target"));
        }
    }
}

#[test]
fn a_reset_forgets_the_pieces_that_wait() {
    let requests = u_cycle(cartesian_blend(40.0, 40.0));
    for released in 0..3 {
        let mut motion = stepping();
        requests.iter().for_each(|request| motion.record(request).unwrap());
        for _ in 0..released {
            motion.release_piece();
            wait(&mut motion, 500);
        }
        let place = motion.joints();
        motion.reset();
        wait(&mut motion, 5);
        assert!(motion.is_empty() && motion.joints() == place && motion.move_id() == 0.0);
        assert!(motion.piece().is_none() && motion.next_piece().is_none() && !motion.waits_for_release());
        motion.record(&Move { blend: Blend::Off, ..requests[0].clone() }).unwrap();
        assert_waits(&mut motion);
        assert!(motion.release_piece());
        wait(&mut motion, 500);
        assert!(motion.joints() != place && motion.is_empty());
    }
}

#[test]
fn a_monitor_speed_of_zero_holds_a_released_arm() {
    let mut motion = stepping();
    motion.record(&u_cycle(Blend::Off)[0]).unwrap();
    motion.set_monitor_speed(Percent(0.0));
    assert!(motion.release_piece());
    wait(&mut motion, 20);
    assert!(motion.joints() == START && !motion.has_arrived());
    motion.set_monitor_speed(Percent(50.0));
    wait(&mut motion, 500);
    assert!(motion.has_arrived() && motion.is_empty());
}

#[test]
fn a_compliant_move_waits_for_its_release() {
    let mut motion = stepping();
    let mut request = u_cycle(Blend::Off).remove(0);
    request.manner = Manner::Compliant(Percent(50.0));
    motion.record(&request).unwrap();
    assert_waits(&mut motion);
    motion.set_external_force(ExternalForce::Path(500.0));
    assert_waits(&mut motion);
    motion.release_piece();
    motion.record(&Move { id: 1.0, ..u_cycle(Blend::Off).remove(1) }).unwrap();
    wait(&mut motion, 2000);
    assert!(motion.has_arrived() && motion.piece().is_some_and(|piece| piece.serial == 0));
    assert_waits(&mut motion);
    motion.release_piece();
    wait(&mut motion, 2000);
    assert!(motion.is_empty());
}

/// The deviation continues to change while the nominal motion waits.
#[test]
fn an_alterable_path_waits_with_its_deviation() {
    let mut motion = stepping();
    for request in u_cycle(cartesian_blend(40.0, 40.0)) {
        motion.record(&Move { manner: Manner::Alterable, ..request }).unwrap();
    }
    motion.release_piece();
    wait(&mut motion, 500);
    let leave = motion.piece().unwrap();
    let limits = limits(500.0, 100.0, 100.0, 9999.0);
    assert_eq!(motion.alter_begin(AlterReference::Frame(IsometryMatrix3::identity()), limits), AlterStatus::Done);
    assert_eq!(motion.alter(IsometryMatrix3::translation(0.0, 0.1, 0.0)), AlterStatus::Done);
    wait(&mut motion, 20);
    let way = motion.commanded_tip() - leave.pose.translation.vector;
    assert!((way - Vector3::new(0.0, 0.1, 0.0)).norm() < 1e-9 && motion.waits_for_release());
    motion.release_piece();
    wait(&mut motion, 500);
    let piece = motion.piece().unwrap();
    let way = motion.commanded_tip() - piece.pose.translation.vector;
    assert!(piece.end == PieceEnd::Reach && (way - Vector3::new(0.0, 0.1, 0.0)).norm() < 1e-9);
}

#[test]
fn an_arm_that_waits_can_be_moved_by_hand_and_returns() {
    let requests = u_cycle(cartesian_blend(40.0, 40.0));
    let reference = reference(&requests).unwrap();
    let mut motion = stepping();
    requests.iter().for_each(|request| motion.record(request).unwrap());
    motion.release_piece();
    arrive_along(&mut motion, &reference);
    let waiting = motion.joints();
    let mut away = waiting;
    away[0] += 5.0;
    motion.displace(away);
    assert!(motion.connection().is_some() && motion.joints() == away);
    motion.connect().unwrap();
    for _ in 0..2000 {
        motion.advance(CYCLE);
    }
    assert_eq!(motion.joints(), waiting);
    assert_waits(&mut motion);
    assert!(motion.release_piece());
    arrive_along(&mut motion, &reference);
    assert_eq!(motion.piece().map(|piece| piece.end), Some(PieceEnd::Reach));
}

#[test]
fn a_path_that_cannot_be_followed_ends_a_piece_there() {
    let mut motion = motion();
    motion.set_mode(MotionMode::Step);
    faults::cut_through_axis_1(&mut motion);
    assert_eq!(motion.pieces().last().map(|piece| piece.end), Some(PieceEnd::Fault));
    motion.release_determined();
    wait(&mut motion, 2000);
    assert!(motion.has_arrived() && !motion.is_empty());
    assert_eq!(motion.piece().map(|piece| piece.joints), Some(motion.joints()));
}

/// User action in a random run.
#[derive(Clone, Copy, Debug)]
enum Action {
    PathPiece,
    Determined,
    Mode(MotionMode),
    Record,
    Stop,
    Restart,
    Speed(f64),
}

fn action() -> impl Strategy<Value = Action> {
    prop_oneof![
        3 => Just(Action::PathPiece),
        2 => Just(Action::Determined),
        1 => Just(Action::Mode(MotionMode::Continuous)),
        2 => Just(Action::Mode(MotionMode::Step)),
        4 => Just(Action::Record),
        1 => Just(Action::Stop),
        2 => Just(Action::Restart),
        1 => (10.0..100.0_f64).prop_map(Action::Speed),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 100, max_global_rejects: 100_000, ..ProptestConfig::default() })]

    /// For any sequence of releases, the arm passes only positions of the continuous run and rests at the ends of
    /// pieces.
    #[test]
    fn steps_never_change_the_path(
        steps in prop::collection::vec(path_independence::step(), 1..6),
        actions in prop::collection::vec((0..60_usize, action()), 5..40),
    ) {
        let requests = requests(&steps, 100.0);
        let reference = reference(&requests);
        prop_assume!(reference.is_some());
        let reference = reference.unwrap();
        let mut motion = stepping();
        let mut waiting = requests.iter();
        for (cycles, action) in &actions {
            match action {
                Action::PathPiece => drop(motion.release_piece()),
                Action::Determined => motion.release_determined(),
                Action::Mode(mode) => motion.set_mode(*mode),
                Action::Record => waiting.next().into_iter().for_each(|request| motion.record(request).unwrap()),
                Action::Stop => motion.stop(),
                Action::Restart => motion.restart(),
                Action::Speed(speed) => motion.set_monitor_speed(Percent(*speed)),
            }
            for _ in 0..*cycles {
                motion.advance(CYCLE);
                prop_assert!(is_on(&motion, &reference), "{:?} at {}", motion.joints(), motion.move_id());
            }
        }
        motion.set_mode(MotionMode::Step);
        motion.restart();
        motion.set_monitor_speed(Percent(100.0));
        waiting.for_each(|request| motion.record(request).unwrap());
        motion.close().unwrap();
        for _ in 0..200 {
            for _ in 0..20_000 {
                motion.advance(CYCLE);
                prop_assert!(is_on(&motion, &reference));
                if motion.has_arrived() {
                    break;
                }
            }
            prop_assert!(motion.has_arrived());
            if let Some(piece) = motion.piece() {
                prop_assert_eq!(piece.joints, motion.joints());
            }
            if !motion.release_piece() {
                break;
            }
        }
        prop_assert!(motion.is_empty());
        prop_assert!((motion.axes() - Axes::from(reference.destination())).amax() < 1e-9);
    }

    /// Along random lines and joint moves, each halt is at the requested distance from the corner.
    #[test]
    fn halts_are_at_the_distances_of_the_descriptors(
        steps in prop::collection::vec(path_independence::step().prop_filter("no circle", |step| !step.is_circle()), 1..6),
    ) {
        let requests = requests(&steps, 100.0);
        let reference = reference(&requests);
        prop_assume!(reference.is_some());
        let targets: Vec<_> = reference.unwrap().moves().map(|queued| queued.joints).collect();
        let starts = std::iter::once(&START).chain(&targets);
        prop_assume!(requests.iter().zip(starts).all(|(request, start)| length(start, request) > 1.0));
        let distances = effective_distances(&requests, &targets);
        let mut motion = stepping();
        requests.iter().for_each(|request| motion.record(request).unwrap());
        while motion.release_piece() {
            let cycles = (0..20_000).take_while(|_| {
                motion.advance(CYCLE);
                !motion.has_arrived()
            });
            prop_assert!(cycles.count() < 20_000);
            let piece = motion.piece().unwrap();
            let Distances { effective, is_reduced, is_limit } = distances[piece.serial as usize];
            let (expected, is_reduced, is_limit) = match piece.end {
                PieceEnd::Leave => (effective[0], is_reduced[0], is_limit[0]),
                PieceEnd::Reach => (effective[1], is_reduced[1], is_limit[1]),
                PieceEnd::Target => (0.0, false, false),
                PieceEnd::Fault => return Err(TestCaseError::fail("the path can be followed")),
            };
            prop_assert_eq!(piece.joints, motion.joints());
            let (distance, tolerance) = distance_from_corner(&piece, &requests, &targets, is_reduced);
            let error = if is_limit { distance - expected } else { (distance - expected).abs() };
            prop_assert!(error < tolerance, "{} instead of {} at {:?}", distance, expected, piece);
        }
    }
}
