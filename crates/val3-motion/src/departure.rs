//! Departure of the arm from its path, after a reset to another start or a motion by hand, and the connection move back
//! to the path (manual 10.6, section (g) of the motion model).

use std::sync::Arc;

use val3_geometry::{IsometryMatrix3, rotation};
use val3_kinematics::{Arm, Joints};
use val3_moves::{Blend, Degrees, DegreesPerSecond, Manner, Millimetres, MillimetresPerSecond, MovePath};

use crate::fault::Cause;
use crate::model::{Axes, Model};
use crate::motion::Motion;
use crate::request::{Move, SpeedLimits};

/// Maximum axis distance from the path for continuing without a connection move, in degrees or mm.
const ON_PATH: f64 = 1e-3;

/// Speed and acceleration of a connection move, relative to the nominal values (model choice).
const SLOW: f64 = 0.1;

/// Maximum speed of the tool centre point in a connection move (model choice).
const TIP: MillimetresPerSecond = MillimetresPerSecond(250.0);

/// Arm state away from the path.
#[derive(Clone, Debug)]
pub(crate) enum Departure {
    /// The arm still brakes on a path that a reset has removed.
    Braking(Box<Motion>),
    /// The arm rests at these axes.
    At(Axes),
    /// The arm executes a connection move.
    Connecting(Box<Motion>),
}

/// Distance back to the path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Connection {
    /// Distance of the tool centre point from the path.
    pub distance: Millimetres,
    /// Rotation of the tool.
    pub rotation: Degrees,
    /// Greatest axis distance, in degrees or mm.
    pub axis: f64,
}

impl Departure {
    /// Creates the departure for an arm that rests at `axes`; `None` if `axes` equals `target`, the position on the
    /// path.
    pub(crate) fn at(axes: Axes, target: &Axes) -> Option<Self> {
        (axes != *target).then_some(Self::At(axes))
    }

    /// Commanded axes.
    pub(crate) fn axes(&self) -> Axes {
        match self {
            Self::At(axes) => *axes,
            Self::Braking(motion) | Self::Connecting(motion) => motion.axes(),
        }
    }

    /// Motion of the arm; `None` if it rests.
    pub(crate) fn motion(&mut self) -> Option<&mut Motion> {
        match self {
            Self::At(_) => None,
            Self::Braking(motion) | Self::Connecting(motion) => Some(motion),
        }
    }
}

impl Connection {
    pub(crate) fn between(model: &Model<'_>, from: &Axes, to: &Axes, tool: &IsometryMatrix3<f64>) -> Self {
        let axis = (from - to).amax();
        let [from, to] = [from, to].map(|axes| model.flange(axes) * tool);
        let turn = rotation::angle_between(&from.rotation, &to.rotation);
        Self {
            distance: Millimetres((to.translation.vector - from.translation.vector).norm()),
            rotation: Degrees(turn.to_degrees()),
            axis,
        }
    }

    /// Whether the arm is too far from the path to continue without a connection move.
    pub(crate) fn is_needed(&self) -> bool {
        self.axis > ON_PATH
    }
}

/// Creates the connection move from one joint position to another.
pub(crate) fn connection(
    arm: &Arc<Arm>,
    from: Joints,
    to: Joints,
    tool: IsometryMatrix3<f64>,
) -> Result<Motion, Cause> {
    let share = |nominal: fn(&Arm, usize) -> f64| std::array::from_fn(|axis| SLOW * nominal(arm, axis));
    let limits = SpeedLimits {
        speed: share(Arm::nominal_speed),
        acceleration: share(Arm::nominal_acceleration),
        deceleration: share(Arm::nominal_deceleration),
        translation: TIP,
        rotation: DegreesPerSecond(f64::MAX),
    };
    let mut motion = Motion::new(Arc::clone(arm), from);
    motion.record(&Move {
        path: MovePath::Joint(to),
        tool,
        limits,
        blend: Blend::Off,
        id: 0.0,
        manner: Manner::Rigid,
    })?;
    Ok(motion)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{MotionPhase, Seconds};

    const START: Joints = [0.0, 0.0, 90.0, 0.0, 90.0, 0.0];
    const END: Joints = [60.0, 0.0, 90.0, 0.0, 90.0, 0.0];
    const AWAY: Joints = [20.0, 10.0, 95.0, 5.0, 85.0, 0.0];

    fn motion() -> Motion {
        Motion::new(Arc::new(Arm::by_name("TX2-90").unwrap()), START)
    }

    fn record(motion: &mut Motion, joints: Joints) {
        let arm = Arm::by_name("TX2-90").unwrap();
        let limits = SpeedLimits {
            speed: std::array::from_fn(|axis| arm.nominal_speed(axis)),
            acceleration: std::array::from_fn(|axis| arm.nominal_acceleration(axis)),
            deceleration: std::array::from_fn(|axis| arm.nominal_deceleration(axis)),
            translation: MillimetresPerSecond(1e6),
            rotation: DegreesPerSecond(1e6),
        };
        let (path, tool) = (MovePath::Joint(joints), IsometryMatrix3::identity());
        motion.record(&Move { path, tool, limits, blend: Blend::Off, id: 7.0, manner: Manner::Rigid }).unwrap();
    }

    fn wait(motion: &mut Motion, cycles: usize) -> Vec<MotionPhase> {
        let mut phases: Vec<_> = (0..cycles).map(|_| motion.advance(Seconds(0.004)).phase).collect();
        phases.dedup();
        phases
    }

    fn held() -> Motion {
        let mut motion = motion();
        record(&mut motion, END);
        wait(&mut motion, 30);
        motion.brake();
        wait(&mut motion, 100);
        motion
    }

    #[test]
    fn an_arm_that_stays_on_its_path_needs_no_connection() {
        let mut motion = held();
        motion.displace(motion.joints());
        assert_eq!(motion.connection(), None);
        motion.resume();
        assert_eq!(wait(&mut motion, 300), [MotionPhase::Nominal, MotionPhase::Waiting]);
        assert_eq!(motion.joints(), END);
    }

    #[test]
    fn an_arm_moved_by_hand_returns_to_where_it_left_its_path() {
        let mut motion = held();
        let left = motion.joints();
        motion.displace(AWAY);
        assert!(motion.connection().is_some_and(|way| way.distance > Millimetres(50.0) && way.rotation > Degrees(1.0)));
        motion.resume();
        assert_eq!(wait(&mut motion, 100), [MotionPhase::Waiting]);
        assert_eq!((motion.joints(), motion.is_empty()), (AWAY, false));

        motion.connect().unwrap();
        let mut back = Vec::new();
        while motion.joints() != left {
            back.push(motion.advance(Seconds(0.004)));
            assert!(back.len() < 5000, "{:?}", motion.joints());
        }
        assert!(back.iter().all(|sample| sample.phase == MotionPhase::Connection && sample.speed <= TIP));
        assert_eq!(wait(&mut motion, 300), [MotionPhase::Nominal, MotionPhase::Waiting]);
        assert_eq!((motion.joints(), motion.move_id()), (END, 8.0));
    }

    #[test]
    fn a_connection_move_is_held_as_any_other() {
        let mut motion = held();
        motion.displace(AWAY);
        motion.resume();
        motion.connect().unwrap();
        wait(&mut motion, 50);
        motion.brake();
        wait(&mut motion, 100);
        let there = motion.joints();
        wait(&mut motion, 10);
        assert!(motion.joints() == there && there != AWAY);
        motion.resume();
        wait(&mut motion, 5000);
        assert_eq!(motion.joints(), END);
    }

    #[test]
    fn the_next_move_can_begin_elsewhere() {
        let mut motion = motion();
        record(&mut motion, END);
        wait(&mut motion, 30);
        motion.reset_to(AWAY);
        record(&mut motion, END);
        assert_eq!(wait(&mut motion, 100), [MotionPhase::Stopping, MotionPhase::Waiting]);
        assert!(motion.joints()[0] < 30.0 && motion.connection().is_some());
        motion.connect().unwrap();
        assert_eq!(wait(&mut motion, 5000), [MotionPhase::Connection, MotionPhase::Nominal, MotionPhase::Waiting]);
        assert_eq!(motion.joints(), END);
    }

    #[test]
    fn a_reset_away_from_the_path_begins_there() {
        let mut motion = held();
        motion.displace(AWAY);
        motion.reset();
        motion.resume();
        assert_eq!((motion.destination(), motion.connection(), motion.is_empty()), (AWAY, None, true));
        record(&mut motion, END);
        wait(&mut motion, 300);
        assert_eq!(motion.joints(), END);
    }

    #[test]
    fn a_start_where_the_arm_rests_needs_no_connection() {
        let mut motion = motion();
        motion.reset_to(START);
        assert_eq!(motion.connection(), None);
        motion.reset_to(AWAY);
        assert!(motion.connection().is_some());
    }
}
