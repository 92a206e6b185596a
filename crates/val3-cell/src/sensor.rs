//! Sensors.

use val3_collision::Shape;
use val3_geometry::IsometryMatrix3;

use crate::carriers::Carrier;

/// A sensor.
#[derive(Debug, Clone)]
pub struct Sensor {
    /// Name in messages and conditions.
    pub name: String,
    /// Path or name of the input; `None` if the sensor sets no input.
    pub io: Option<String>,
    /// Whether the input is false while the sensor detects something.
    pub is_inverted: bool,
    /// Delay in seconds between the detection and the change of the input.
    pub delay: f64,
    /// Carrier of the beam or zone.
    pub carrier: Carrier,
    /// Beam or zone.
    pub(crate) shape: Shape,
    /// Pose of the shape in the carrier's frame.
    pub(crate) pose: IsometryMatrix3<f64>,
    /// Bodies that the sensor detects.
    pub(crate) detects: Detects,
    /// Form of the beam or zone, for pictures.
    pub form: SensorForm,
}

/// Bodies that a sensor detects.
#[derive(Debug, Clone)]
pub(crate) enum Detects {
    Parts,
    Named(Vec<globset::GlobMatcher>),
}

/// Form of a sensor's beam or zone, for pictures.
#[derive(Debug, Clone, PartialEq)]
pub enum SensorForm {
    /// Ends of a beam.
    Beam([[f64; 3]; 2]),
    /// Form of a zone.
    Zone(crate::solids::SolidForm),
}
