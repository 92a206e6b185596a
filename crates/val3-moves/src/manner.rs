//! Manner in which the arm follows a move's path, and the coordinates of a deviation.

use val3_geometry::IsometryMatrix3;

use crate::units::Percent;

/// Manner in which the arm follows a move's path.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Manner {
    /// The arm follows the path exactly.
    #[default]
    Rigid,
    /// A force in per cent of the nominal load moves the arm along the path (`movejf`, `movelf`; 11.1). The arm stops
    /// at both ends.
    Compliant(Percent),
    /// `alter` deviates the arm from the path (`alterMovej`, `alterMovel`, `alterMovec`; 11.2).
    Alterable,
}

/// Coordinates of `alter` transformations (11.2.6).
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum AlterReference {
    /// Pose of a frame in `world`: the path is rotated around the frame's origin, then moved.
    Frame(IsometryMatrix3<f64>),
    /// Pose of a tool on the flange: the arm is rotated around the tool centre point and moved along the tool's axes.
    Tool(IsometryMatrix3<f64>),
}
