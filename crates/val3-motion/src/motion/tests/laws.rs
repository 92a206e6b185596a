//! Properties of the arm's position under random events.

use proptest::prelude::*;
use val3_geometry::Vector3;

use super::*;
use crate::{AlterReference, AlterStatus, ExternalForce, Jog};

/// Disturbance during the execution of a program.
#[derive(Clone, Debug)]
enum Event {
    Stop,
    Restart,
    Brake,
    Resume,
    MonitorSpeed(f64),
    Force(f64),
    Jog(Joints),
    Connect,
}

fn event() -> impl Strategy<Value = Event> {
    prop_oneof![
        Just(Event::Stop),
        Just(Event::Restart),
        Just(Event::Brake),
        Just(Event::Resume),
        prop_oneof![Just(0.0), 1.0..100.0_f64].prop_map(Event::MonitorSpeed),
        (-800.0..800.0_f64).prop_map(Event::Force),
        prop::array::uniform6(-20.0..20.0_f64).prop_map(Event::Jog),
        Just(Event::Connect),
    ]
}

fn events() -> impl Strategy<Value = Vec<(usize, Event)>> {
    prop::collection::vec((1..80_usize, event()), 1..20)
}

fn happen(motion: &mut Motion, event: &Event) {
    match event {
        Event::Stop => motion.stop(),
        Event::Restart => motion.restart(),
        Event::Brake => motion.brake(),
        Event::Resume => motion.resume(),
        Event::MonitorSpeed(speed) => motion.set_monitor_speed(Percent(*speed)),
        Event::Force(force) => motion.set_external_force(ExternalForce::World(Vector3::y() * *force)),
        Event::Jog(speeds) => drop(motion.jog(&Jog::Joints(*speeds), CYCLE)),
        Event::Connect => drop(motion.connect()),
    }
}

/// Removes all holds.
fn release(motion: &mut Motion) {
    motion.restart();
    motion.resume();
    motion.set_monitor_speed(Percent(100.0));
    motion.set_external_force(ExternalForce::Path(500.0));
    motion.connect().unwrap();
}

fn square(motion: &mut Motion, blend: Blend, manner: Manner) {
    let corners = [(200.0, 0.0), (200.0, -150.0), (0.0, -150.0), (0.0, 0.0)];
    for ((y, z), id) in corners.into_iter().zip([0.0, 1.0, 2.0, 3.0]) {
        let request = request(line(moved(0.0, y, z)), limits(100.0, 100.0, 100.0, 400.0), blend, id);
        motion.record(&Move { manner, ..request }).unwrap();
    }
    motion.close().unwrap();
}

/// Distance from a position to the sides of the square, in mm.
fn from_square(place: &Vector3<f64>) -> f64 {
    let offset = place - moved(0.0, 0.0, 0.0).translation.vector;
    let beside = |value: f64, from: f64, to: f64| (from - value).max(value - to).max(0.0);
    let sides = [
        (offset.z, beside(offset.y, 0.0, 200.0)),
        (offset.z + 150.0, beside(offset.y, 0.0, 200.0)),
        (offset.y, beside(offset.z, -150.0, 0.0)),
        (offset.y - 200.0, beside(offset.z, -150.0, 0.0)),
    ];
    let distances = sides.iter().map(|(across, along)| Vector3::new(*across, *along, offset.x).norm());
    distances.fold(f64::INFINITY, f64::min)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    /// Rigid and compliant moves: the tool centre point is on the path unless the arm is jogged or returns to the path.
    #[test]
    fn an_arm_stays_on_its_path_whatever_happens(
        force in prop_oneof![Just(None), (-300.0..300.0_f64).prop_map(Some)],
        events in events(),
    ) {
        let mut motion = motion();
        square(&mut motion, Blend::Off, force.map_or(Manner::Rigid, |force| Manner::Compliant(Percent(force))));
        let mut before = motion.joints();
        let mut id = 0.0;
        for (cycles, event) in &events {
            // Without a move, a jog has no path to leave.
            if motion.is_empty() && matches!(event, Event::Jog(_)) {
                continue;
            }
            happen(&mut motion, event);
            for _ in 0..*cycles {
                let is_away = motion.joints() != Joints::from(motion.axes_on_path());
                let sample = motion.advance(CYCLE);
                let deviation = from_square(&sample.pose.translation.vector);
                prop_assert!(is_away || deviation < 1e-6, "{} mm from the path at {}", deviation, sample.id);
                let speeds = sample.joints.iter().zip(before).zip(NOMINAL);
                let used = speeds.map(|((now, before), limit)| (now - before).abs() / CYCLE.0 / limit);
                prop_assert!(is_away || used.fold(0.0, f64::max) < 1.001);
                prop_assert!(force.is_some() || sample.id >= id, "{} after {}", sample.id, id);
                (before, id) = (sample.joints, sample.id);
            }
        }
        release(&mut motion);
        for _ in 0..20_000 {
            motion.advance(CYCLE);
            if motion.is_empty() {
                break;
            }
        }
        prop_assert!(motion.is_empty() && motion.move_id() == 4.0);
        prop_assert!((arm().flange(&motion.joints()).translation.vector - moved(0.0, 0.0, 0.0).translation.vector).norm() < 1e-6);
    }

    /// `resetMotion` removes all moves, also those that were recorded while the arm was held.
    #[test]
    fn nothing_remains_of_the_moves_after_a_reset(rounds in prop::collection::vec((events(), 1..4_usize), 1..6)) {
        let mut motion = motion();
        for (events, moves) in &rounds {
            let mut moves = 0..*moves;
            for (cycles, event) in events {
                if let Some(number) = moves.next() {
                    let side = if number % 2 == 0 { 20.0 } else { -20.0 };
                    let path = MovePath::Joint([side, 0.0, 90.0, 0.0, 90.0, 0.0]);
                    // A connection that is not finished permits no moves.
                    _ = motion.record(&request(path, fast(), Blend::Off, 0.0));
                }
                happen(&mut motion, event);
                wait(&mut motion, *cycles);
            }
            motion.reset();
            wait(&mut motion, 500);
            prop_assert!(motion.is_empty() && motion.moves().len() == 0);
        }
    }

    /// A constant deviation shifts the path, stops included.
    #[test]
    fn an_arm_stays_on_its_deviating_path_whatever_happens(
        shift in prop::array::uniform3(-15.0..15.0_f64),
        events in events(),
    ) {
        let corner = Blend::Cartesian { leave: Millimetres(20.0), reach: Millimetres(20.0) };
        let (mut plain, mut altered) = (motion(), motion());
        for motion in [&mut plain, &mut altered] {
            square(motion, corner, Manner::Alterable);
            wait(motion, 10);
        }
        let limits = limits(500.0, 100.0, 100.0, 9999.0);
        prop_assert_eq!(altered.alter_begin(AlterReference::Frame(IsometryMatrix3::identity()), limits), AlterStatus::Done);
        let shift = Vector3::from(shift);
        for cycle in 1..=20 {
            altered.alter(IsometryMatrix3::from_parts((shift * f64::from(cycle) / 20.0).into(), Default::default()));
            altered.advance(CYCLE);
            plain.advance(CYCLE);
        }
        let is_hand = |event: &Event| matches!(event, Event::Jog(_) | Event::Connect);
        for (cycles, event) in events.iter().filter(|(_, event)| !is_hand(event)) {
            happen(&mut altered, event);
            happen(&mut plain, event);
            for _ in 0..*cycles {
                let (plain, altered) = (plain.advance(CYCLE), altered.advance(CYCLE));
                let deviation = altered.pose.translation.vector - plain.pose.translation.vector;
                prop_assert!((deviation - shift).norm() < 1e-6 && plain.id == altered.id);
            }
        }
    }

    /// A clone is a snapshot: it continues exactly like the original.
    #[test]
    fn a_copy_continues_as_the_original(events in events(), at in 0..20_usize) {
        let mut motion = motion();
        square(&mut motion, Blend::Cartesian { leave: Millimetres(20.0), reach: Millimetres(20.0) }, Manner::Alterable);
        let mut copy = motion.clone();
        for (index, (cycles, event)) in events.iter().enumerate() {
            if index == at {
                copy = motion.clone();
            }
            happen(&mut motion, event);
            if index >= at {
                happen(&mut copy, event);
            }
            for _ in 0..*cycles {
                let sample = motion.advance(CYCLE);
                prop_assert!(index < at || sample == copy.advance(CYCLE));
            }
        }
    }
}
