//! Causes for which the arm cannot follow a path.

use proptest::prelude::*;
use val3_geometry::Vector3;
use val3_kinematics::Unreachable;

use super::*;
use crate::Cause;

/// Line or circle from the end of the previous move, with a tool rotation.
#[derive(Clone, Debug)]
struct Path {
    offset: [f64; 3],
    turn: [f64; 3],
    through: Option<[f64; 3]>,
    leave: f64,
}

fn path() -> impl Strategy<Value = Path> {
    let offset = || prop::array::uniform3(-200.0..200.0_f64);
    let leave = prop_oneof![Just(0.0), 1.0..150.0_f64];
    (offset(), prop::array::uniform3(-80.0..80.0_f64), prop::option::of(offset()), leave)
        .prop_map(|(offset, turn, through, leave)| Path { offset, turn, through, leave })
}

fn start() -> impl Strategy<Value = Joints> {
    let wrist = prop_oneof![20.0..110.0_f64, -100.0..-20.0_f64];
    (-100.0..100.0_f64, -40.0..50.0_f64, 50.0..120.0_f64, -250.0..250.0_f64, wrist, -250.0..250.0_f64)
        .prop_map(|(a, b, c, d, e, f)| [a, b, c, d, e, f])
}

/// First cause for which an arm cannot follow the paths.
fn reason(arm: Arm, start: Joints, paths: &[Path]) -> Option<Cause> {
    let mut motion = Motion::new(Arc::new(arm), start);
    for (path, id) in paths.iter().zip(0..) {
        let from = motion.arm.flange(&motion.destination());
        let pose = shifted(&from, path.offset, path.turn);
        let to = MoveTarget { pose, configuration: RequestedConfiguration::SAME };
        let shape = match path.through {
            Some(through) => MovePath::Circle(shifted(&from, through, path.turn.map(|angle| angle / 2.0)), to),
            None => MovePath::Line(to),
        };
        let blend = Blend::Cartesian { leave: Millimetres(path.leave), reach: Millimetres(path.leave) };
        if let Err(cause) = motion.record(&request(shape, fast(), blend, f64::from(id))) {
            return Some(cause);
        }
    }
    if let Err(cause) = motion.close() {
        return Some(cause);
    }
    motion.fault().cloned()
}

/// Pose with an offset along the axes of `world`, turned about its own axes.
fn shifted(from: &IsometryMatrix3<f64>, offset: [f64; 3], turn: [f64; 3]) -> IsometryMatrix3<f64> {
    let rotation = from.rotation * Trsf::new([0.0; 3], turn).isometry().rotation;
    IsometryMatrix3::from_parts((from.translation.vector + Vector3::from(offset)).into(), rotation)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, max_global_rejects: 100_000, ..ProptestConfig::default() })]

    /// If one arm can follow a path and the same arm with a narrower axis range cannot, the cause is the axis limit.
    #[test]
    fn an_axis_limit_is_never_called_a_singularity(
        start in start(),
        paths in prop::collection::vec(path(), 1..3),
        axis in 0..6_usize,
        is_upper in any::<bool>(),
        room in 0.1..40.0_f64,
    ) {
        prop_assume!(reason(arm(), start, &paths).is_none());
        let (mut min, mut max) = ([-99999.0; 6], [99999.0; 6]);
        if is_upper { max[axis] = start[axis] + room } else { min[axis] = start[axis] - room }
        let narrow = arm().with_limits(&min, &max);
        prop_assume!(narrow.is_ok());
        let named = match reason(narrow.unwrap(), start, &paths) {
            None => return Ok(()),
            Some(Cause::Unreachable(Unreachable::Limit { axis, .. }) | Cause::Intermediate(Unreachable::Limit { axis, .. })) => axis,
            Some(other) => return Err(TestCaseError::fail(format!("axis {}: {other:?}", axis + 1))),
        };
        prop_assert_eq!(named, axis + 1);
    }
}
