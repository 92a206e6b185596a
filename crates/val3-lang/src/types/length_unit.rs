//! An application's length unit (2.1.4.1).

/// Unit of an application's lengths: frames, points, tools, transformations, linear axes, blending distances. The
/// numbers are never converted; only the arm needs the unit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum LengthUnit {
    /// Millimetres.
    #[default]
    Millimetre,
    /// Inches.
    Inch,
}

impl LengthUnit {
    /// Number of millimetres in one unit.
    #[must_use]
    pub fn millimetres(self) -> f64 {
        match self {
            Self::Millimetre => 1.0,
            Self::Inch => 25.4,
        }
    }
}
