//! Moves as instructions request them, in the numbers of the planner.

use val3_kinematics::{Arm, Joints, Unreachable};
use val3_lang::ports::{Manner as RequestedManner, MoveRequest, PointTarget, RequestedPath};
use val3_lang::values::MdescValue;
use val3_motion::{
    Blend, DegreesPerSecond, Destination, Limits, Manner, Millimetres, MillimetresPerSecond, Move, MovePath, Percent,
};

/// The places of `off` and `Cartesian` among the values of `blend`; `joint` is the first.
const OFF: f64 = 1.0;
const CARTESIAN: f64 = 2.0;

/// The move of a request that begins at `start` and gets this id.
///
/// # Errors
/// A joint move leads to a point that cannot be reached.
pub(super) fn to_move(arm: &Arm, request: &MoveRequest, start: &Joints, id: f64) -> Result<Move, Unreachable> {
    let MoveRequest { path, tool, descriptor, manner, .. } = request;
    let path = match path {
        RequestedPath::Joint(joint) => MovePath::Joint(*joint),
        RequestedPath::JointToPoint(PointTarget { pose, configuration }) => {
            MovePath::Joint(arm.solve(&(pose * tool.inverse()).into(), start, *configuration)?)
        }
        RequestedPath::Line(target) => MovePath::Line(destination(target)),
        RequestedPath::Circle(intermediate, target) => MovePath::Circle(*intermediate, destination(target)),
    };
    let manner = match manner {
        RequestedManner::Rigid => Manner::Rigid,
        RequestedManner::Compliant(force) => Manner::Compliant(Percent(*force)),
        RequestedManner::Alterable => Manner::Alterable,
    };
    Ok(Move { path, tool: *tool, limits: limits(arm, descriptor), blend: blend(descriptor), id, manner })
}

fn destination(target: &PointTarget) -> Destination {
    Destination { pose: target.pose, configuration: target.configuration }
}

/// The limits of a descriptor, whose per cents are those of the arm's nominal values (10.3.4).
pub(super) fn limits(arm: &Arm, descriptor: &MdescValue) -> Limits {
    let share = |per_cent: f64, nominal: fn(&Arm, usize) -> f64| {
        std::array::from_fn(|axis| per_cent / 100.0 * nominal(arm, axis))
    };
    Limits {
        speed: share(descriptor.vel, Arm::nominal_speed),
        acceleration: share(descriptor.accel, Arm::nominal_acceleration),
        deceleration: share(descriptor.decel, Arm::nominal_deceleration),
        translation: MillimetresPerSecond(descriptor.tvel),
        rotation: DegreesPerSecond(descriptor.rvel),
    }
}

fn blend(descriptor: &MdescValue) -> Blend {
    let (leave, reach) = (Millimetres(descriptor.leave), Millimetres(descriptor.reach));
    match descriptor.blend {
        OFF => Blend::Off,
        CARTESIAN => Blend::Cartesian { leave, reach },
        _ => Blend::Joint { leave, reach },
    }
}
