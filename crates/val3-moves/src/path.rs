//! Nominal path of a move, and its destination.

use val3_geometry::IsometryMatrix3;
use val3_kinematics::{Joints, RequestedConfiguration};

/// Nominal path and destination of a move.
#[derive(Clone, Debug)]
pub enum MovePath {
    /// `movej` to a joint position: a straight line in joint space.
    Joint(Joints),
    /// `movej` to a point: a straight line in joint space. The joint position at the destination follows from the
    /// start of the move.
    JointToPoint(MoveTarget),
    /// `movel`: a straight line of the tool centre point.
    Line(MoveTarget),
    /// `movec`: a circle of the tool centre point. The first field is the intermediate pose.
    Circle(IsometryMatrix3<f64>, MoveTarget),
}

/// Point as the destination of a move.
#[derive(Clone, Debug)]
pub struct MoveTarget {
    /// Tool centre point in `world`.
    pub pose: IsometryMatrix3<f64>,
    /// Configurations in which the arm may reach the pose (9.7).
    pub configuration: RequestedConfiguration,
}

/// Shape of a nominal path.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PathShape {
    /// A straight line in joint space.
    Joint,
    /// A straight line of the tool centre point.
    Line,
    /// A circle of the tool centre point.
    Circle,
}

impl MovePath {
    /// Shape of the path.
    #[must_use]
    pub const fn shape(&self) -> PathShape {
        match self {
            Self::Joint(_) | Self::JointToPoint(_) => PathShape::Joint,
            Self::Line(_) => PathShape::Line,
            Self::Circle(..) => PathShape::Circle,
        }
    }

    /// Intermediate pose of a circle; `None` for other shapes.
    #[must_use]
    pub const fn intermediate(&self) -> Option<&IsometryMatrix3<f64>> {
        if let Self::Circle(pose, _) = self { Some(pose) } else { None }
    }
}

#[cfg(test)]
mod tests {
    use super::{IsometryMatrix3, MovePath, MoveTarget, PathShape, RequestedConfiguration};

    #[test]
    fn only_a_circle_has_an_intermediate_pose() {
        let target = || MoveTarget { pose: IsometryMatrix3::identity(), configuration: RequestedConfiguration::SAME };
        let above = IsometryMatrix3::translation(0.0, 0.0, 50.0);
        let paths = [
            MovePath::Joint([0.0; 6]),
            MovePath::JointToPoint(target()),
            MovePath::Line(target()),
            MovePath::Circle(above, target()),
        ];
        let shapes = paths.each_ref().map(MovePath::shape);
        assert_eq!(shapes, [PathShape::Joint, PathShape::Joint, PathShape::Line, PathShape::Circle]);
        assert_eq!(paths.each_ref().map(MovePath::intermediate), [None, None, None, Some(&above)]);
    }
}
