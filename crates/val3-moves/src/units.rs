//! Units of lengths, angles, speeds, times and shares.

/// A length in mm.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Millimetres(pub f64);

/// An angle in degrees.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Degrees(pub f64);

/// A speed in mm/s.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct MillimetresPerSecond(pub f64);

/// A speed of rotation in degrees per second.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct DegreesPerSecond(pub f64);

/// A duration or a time in seconds.
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
pub struct Seconds(pub f64);

/// A share in per cent, such as the monitor speed.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Percent(pub f64);
