//! The length unit of an application (2.1.4.1).

/// The unit of the lengths of an application: frames, points, tools, transformations, linear axes, blending distances.
/// Its numbers are never converted; only the arm has to know.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum LengthUnit {
    /// Millimetres.
    #[default]
    Millimetre,
    /// Inches.
    Inch,
}

impl LengthUnit {
    /// Millimetres of one unit.
    #[must_use]
    pub fn millimetres(self) -> f64 {
        match self {
            Self::Millimetre => 1.0,
            Self::Inch => 25.4,
        }
    }
}
