//! Random programs: speeds, stops and the time of recording never change the path.

use proptest::prelude::*;

use super::*;

#[derive(Clone, Debug)]
enum Shape {
    Joint([f64; 6]),
    Line([f64; 3], [f64; 3]),
    Circle([f64; 3], [f64; 3]),
}

#[derive(Clone, Debug)]
pub(super) struct Step {
    shape: Shape,
    blend: Blend,
}

impl Step {
    pub(super) fn is_circle(&self) -> bool {
        matches!(self.shape, Shape::Circle(..))
    }
}

pub(super) fn step() -> impl Strategy<Value = Step> {
    let offset = || prop::array::uniform3(-150.0..150.0_f64);
    let angles = prop::array::uniform3(-20.0..20.0_f64);
    let shape = prop_oneof![
        prop::array::uniform6(-20.0..20.0_f64).prop_map(Shape::Joint),
        (offset(), angles).prop_map(|(offset, angles)| Shape::Line(offset, angles)),
        (offset(), offset()).prop_map(|(through, to)| Shape::Circle(through, to)),
    ];
    let distances = || (0.0..120.0_f64, 0.0..120.0_f64);
    let blend = prop_oneof![
        Just(Blend::Off),
        distances().prop_map(|(leave, reach)| Blend::Joint { leave: Millimetres(leave), reach: Millimetres(reach) }),
        distances()
            .prop_map(|(leave, reach)| Blend::Cartesian { leave: Millimetres(leave), reach: Millimetres(reach) }),
    ];
    (shape, blend).prop_map(|(shape, blend)| Step { shape, blend })
}

pub(super) fn requests(steps: &[Step], vel: f64) -> Vec<Move> {
    let ids = (0..).map(f64::from);
    let limits = limits(vel, 100.0, 100.0, 99999.0);
    steps.iter().zip(ids).map(|(step, id)| request(step.shape.path(), limits, step.blend, id)).collect()
}

impl Shape {
    fn path(&self) -> MovePath {
        let at = |[x, y, z]: [f64; 3]| moved(x, y, z);
        match self {
            Self::Joint(offsets) => {
                let mut joints = START;
                joints.iter_mut().zip(offsets).for_each(|(joint, offset)| *joint += offset);
                MovePath::Joint(joints)
            }
            Self::Line(offset, angles) => line(at(*offset) * Trsf::new([0.0; 3], *angles).isometry()),
            Self::Circle(through, to) => {
                let to = MoveTarget { pose: at(*to), configuration: RequestedConfiguration::FREE };
                MovePath::Circle(at(*through), to)
            }
        }
    }
}

/// Motion with a completely recorded program; `None` if the arm cannot follow the path.
pub(super) fn reference(requests: &[Move]) -> Option<Motion> {
    let mut motion = motion();
    requests.iter().try_for_each(|request| motion.record(request)).ok()?;
    motion.close().ok()?;
    Some(motion)
}

/// Greatest difference between the arm and the reference path, in degrees or mm.
pub(super) fn deviation(reference: &Motion, motion: &Motion) -> f64 {
    let (Some(front), Some(p)) = (motion.timeline.spans.front(), motion.timeline.p()) else { return 0.0 };
    let model = Model(&motion.arm);
    let spans = reference.timeline.spans.iter().filter(|other| {
        let [from, to] = other.span.range();
        other.span.part == front.span.part && (from..=to).contains(&p)
    });
    let tip = |axes: &Axes| model.flange(axes).translation.vector;
    let difference = |other: Axes| (other - motion.axes()).amax().max((tip(&other) - tip(&motion.axes())).norm());
    let differences = spans.map(|other| difference(other.span.axes(&model, p)));
    differences.fold(f64::INFINITY, f64::min)
}

/// Runs a program whose moves are recorded as late as `early` permits, with disturbances from a sequence of choices.
fn follow(reference: &Motion, requests: &[Move], early: f64, choices: &[u8]) -> Result<(), TestCaseError> {
    let mut motion = motion();
    let mut waiting = requests.iter();
    let mut more = true;
    for cycle in 0..50_000 {
        while more && motion.time_left().0 <= early {
            more = match waiting.next() {
                Some(request) => {
                    motion.record(request).unwrap();
                    true
                }
                None => {
                    motion.close().unwrap();
                    false
                }
            };
        }
        match choices[cycle / 25 % choices.len()] {
            _ if cycle % 25 != 0 => (),
            0 => motion.stop(),
            speed if speed < 100 => {
                motion.restart();
                motion.set_monitor_speed(Percent(f64::from(speed.max(50))));
            }
            _ => motion.restart(),
        }
        motion.advance(CYCLE);
        let deviation = deviation(reference, &motion);
        prop_assert!(deviation < 1e-6, "{} degrees or mm from the path at {}", deviation, motion.move_id());
        if !more && motion.is_empty() {
            return Ok(());
        }
    }
    Err(TestCaseError::fail("the program does not end"))
}

/// Greatest speed between two samples, relative to the speed limit.
fn used(before: &Sample, after: &Sample, limits: &SpeedLimits) -> f64 {
    let axes = before.joints.iter().zip(after.joints).zip(limits.speed);
    let fastest = axes.map(|((before, after), limit)| (after - before).abs() / CYCLE.0 / limit).fold(0.0, f64::max);
    fastest.max(after.speed.0 / limits.translation.0)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, max_global_rejects: 100_000, ..ProptestConfig::default() })]

    #[test]
    fn the_path_is_fixed_by_the_moves_alone(
        steps in prop::collection::vec(step(), 1..6),
        vel in 5.0..100.0_f64,
        early in prop_oneof![Just(0.0), 0.0..1.0_f64, Just(f64::INFINITY)],
        choices in prop::collection::vec(prop_oneof![1 => 0..=2_u8, 4 => 50..=200_u8], 5..20),
    ) {
        let reference = reference(&requests(&steps, 100.0));
        prop_assume!(reference.is_some());
        prop_assume!(choices.iter().filter(|choice| **choice < 3).count() * 2 < choices.len());
        follow(&reference.unwrap(), &requests(&steps, vel), early, &choices)?;
    }

    #[test]
    fn limits_of_speed_are_kept_and_ids_never_fall(
        steps in prop::collection::vec(step(), 1..6),
        vel in 20.0..100.0_f64,
        tvel in prop_oneof![Just(99999.0), 50.0..500.0_f64],
    ) {
        let mut requests = requests(&steps, vel);
        requests.iter_mut().for_each(|request| request.limits.translation = MillimetresPerSecond(tvel));
        let motion = reference(&requests);
        prop_assume!(motion.is_some());
        let samples = run(&mut motion.unwrap(), |_, _| ());
        for pair in samples.windows(2) {
            let used = used(&pair[0], &pair[1], &requests[0].limits);
            // A span is within the limit at its knots, and a blend exceeds it slightly between knots.
            prop_assert!(used < 1.000_1, "{} of the limit at {}", used, pair[1].id);
            prop_assert!(pair[0].id <= pair[1].id + 1e-9, "{} after {}", pair[1].id, pair[0].id);
        }
    }
}
