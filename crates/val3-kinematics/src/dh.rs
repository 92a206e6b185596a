//! Geometric parameters (manual 11.4.1).

use std::error::Error;
use std::fmt;

use val3_geometry::{IsometryMatrix3, Trsf};

/// Largest difference between a calibrated and a nominal length, in mm (model choice).
const LENGTH_TOLERANCE: f64 = 5.0;

/// Largest difference between a calibrated and a nominal angle, in degrees (model choice).
const ANGLE_TOLERANCE: f64 = 2.0;

/// Geometric parameters: lengths in mm, angles in degrees. A SCARA arm uses the first four rows, and its flange `d[4]`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dh {
    /// Rotation about z, added to the joint position.
    pub theta: [f64; 6],
    /// Translation along z. The entry after the last axis belongs to the flange.
    pub d: [f64; 7],
    /// Translation along x.
    pub a: [f64; 6],
    /// Translation along y.
    pub b: [f64; 6],
    /// Rotation about x.
    pub alpha: [f64; 6],
    /// Rotation about the new y.
    pub beta: [f64; 6],
}

/// A geometric parameter that differs too much from its nominal value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DhError {
    /// Array name: `theta`, `d`, `a`, `b`, `alpha` or `beta`.
    pub parameter: &'static str,
    /// Index in the array.
    pub index: usize,
    /// Rejected value.
    pub value: f64,
    /// Nominal value.
    pub nominal: f64,
    /// Largest accepted difference.
    pub tolerance: f64,
}

impl Dh {
    /// Returns the transformation of the link after axis `index` (from 0) at this joint position.
    pub(crate) fn link(&self, index: usize, joint: f64, is_stroke: bool) -> IsometryMatrix3<f64> {
        let at = |values: &[f64]| values.get(index).copied().unwrap_or_default();
        let (angle, stroke) = if is_stroke { (0.0, joint) } else { (joint, 0.0) };
        let turn = Trsf::new([0.0; 3], [0.0, 0.0, angle + at(&self.theta)]);
        let link = Trsf::new([at(&self.a), at(&self.b), at(&self.d) + stroke], [at(&self.alpha), at(&self.beta), 0.0]);
        turn.isometry() * link.isometry()
    }

    /// Checks that all parameters are within the tolerances of the nominal parameters.
    pub(crate) fn check(&self, nominal: &Self) -> Result<(), DhError> {
        check("theta", &self.theta, &nominal.theta, ANGLE_TOLERANCE)?;
        check("d", &self.d, &nominal.d, LENGTH_TOLERANCE)?;
        check("a", &self.a, &nominal.a, LENGTH_TOLERANCE)?;
        check("b", &self.b, &nominal.b, LENGTH_TOLERANCE)?;
        check("alpha", &self.alpha, &nominal.alpha, ANGLE_TOLERANCE)?;
        check("beta", &self.beta, &nominal.beta, ANGLE_TOLERANCE)
    }
}

fn check(parameter: &'static str, values: &[f64], nominal: &[f64], tolerance: f64) -> Result<(), DhError> {
    for (index, (&value, &nominal)) in values.iter().zip(nominal).enumerate() {
        let near = (value - nominal).abs() <= tolerance;
        if !near {
            return Err(DhError { parameter, index, value, nominal, tolerance });
        }
    }
    Ok(())
}

impl fmt::Display for DhError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { parameter, index, value, nominal, tolerance } = self;
        write!(f, "{parameter}[{index}] is {value}, which differs by more than {tolerance} from the nominal {nominal}")
    }
}

impl Error for DhError {}
