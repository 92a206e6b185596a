//! Units of length, angle, speed and time, and per cent.

/// Length in mm.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Millimetres(pub f64);

/// Angle in degrees.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Degrees(pub f64);

/// Speed in mm/s.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct MillimetresPerSecond(pub f64);

/// Rotation speed in degrees per second.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct DegreesPerSecond(pub f64);

/// Duration or time in seconds.
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
pub struct Seconds(pub f64);

/// Ratio in per cent, for example the monitor speed.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Percent(pub f64);
