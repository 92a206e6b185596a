//! Blend around a move's destination (10.1.2).

use crate::units::Millimetres;

/// Distance to the destination below which a blend distance counts as 0, in mm.
const LEAST_CORNER: f64 = 1e-3;

/// Value of the field `blend` of a motion descriptor, without the distances.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BlendKind {
    /// A smooth curve in joint space.
    Joint,
    /// The arm stops at the destination.
    Off,
    /// Two circular arcs of the tool centre point.
    Cartesian,
}

/// Blend of a move, with the distances from the tool centre point to the destination.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Blend {
    /// The arm stops at the destination.
    Off,
    /// A smooth curve in joint space.
    Joint {
        /// Distance to the destination at which the nominal path ends.
        leave: Millimetres,
        /// Distance to the destination at which the path of the next move begins.
        reach: Millimetres,
    },
    /// Two circular arcs of the tool centre point.
    Cartesian {
        /// Distance to the destination at which the nominal path ends.
        leave: Millimetres,
        /// Distance to the destination at which the path of the next move begins.
        reach: Millimetres,
    },
}

impl Blend {
    /// Creates a blend. [`BlendKind::Off`] ignores the distances.
    #[must_use]
    pub const fn new(kind: BlendKind, leave: Millimetres, reach: Millimetres) -> Self {
        match kind {
            BlendKind::Off => Self::Off,
            BlendKind::Joint => Self::Joint { leave, reach },
            BlendKind::Cartesian => Self::Cartesian { leave, reach },
        }
    }

    /// `leave` and `reach` in mm; less than 0.001 mm counts as 0. `None` if the arm stops.
    #[must_use]
    pub fn distances(&self) -> Option<(f64, f64)> {
        let (Self::Joint { leave, reach } | Self::Cartesian { leave, reach }) = self else { return None };
        let [leave, reach] = [leave.0, reach.0].map(|distance| if distance < LEAST_CORNER { 0.0 } else { distance });
        (leave > 0.0 || reach > 0.0).then_some((leave, reach))
    }
}

#[cfg(test)]
mod tests {
    use super::{Blend, BlendKind, Millimetres};

    #[test]
    fn distances_below_a_thousandth_are_none() {
        let distances = |kind, leave, reach| Blend::new(kind, Millimetres(leave), Millimetres(reach)).distances();
        assert_eq!(distances(BlendKind::Joint, 20.0, 1e-4), Some((20.0, 0.0)));
        assert_eq!(distances(BlendKind::Cartesian, 0.0, 1e-3), Some((0.0, 1e-3)));
        assert_eq!(distances(BlendKind::Joint, 1e-4, 0.0), None);
        assert_eq!(distances(BlendKind::Off, 20.0, 20.0), None);
    }
}
