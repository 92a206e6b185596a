//! Sensors: detection of bodies, and delayed changes of inputs.

use std::collections::VecDeque;

use val3_collision::{Bounds, Nearness, PlacedShape, Shape, nearest};
use val3_geometry::IsometryMatrix3;

use super::{Handling, HandlingEvent, HandlingView, SAME_TIME};
use crate::allowed::is_named;
use crate::gripper::SignalWrite;
use crate::scene::{Body, BodyCarrier};
use crate::sensor::{Detects, Sensor};

/// State of a sensor.
#[derive(Debug, Clone, Default)]
pub(super) struct SensorState {
    /// Whether the sensor detects something; `None` before the first cycle.
    detects: Option<bool>,
    /// Pending input changes, with their times in seconds.
    pending: VecDeque<(f64, bool)>,
}

impl SensorState {
    pub(super) fn detects(&self) -> bool {
        self.detects.unwrap_or_default()
    }

    pub(super) fn next_due(&self) -> Option<f64> {
        self.pending.front().map(|(time, _)| *time)
    }
}

impl Handling {
    /// Evaluates a sensor, and requests the changes of its input that are due. Returns an event if the sensor begins or
    /// ceases to detect something.
    pub(super) fn sense(&mut self, number: usize, view: &HandlingView<'_>) -> Option<HandlingEvent> {
        let sensor = view.scene.cell().sensors.get(number)?;
        let detected = self.detected(sensor, view);
        let state = self.sensors.get_mut(number)?;
        let before = state.detects.replace(detected.is_some());
        let has_changed = before != Some(detected.is_some());
        if has_changed {
            // At the start, the input changes without a delay.
            let delay = if before.is_none() { 0.0 } else { sensor.delay };
            state.pending.push_back((view.sight.time + delay, detected.is_some()));
        }
        while let Some((_, detects)) = state.pending.pop_front_if(|(time, _)| *time <= view.sight.time + SAME_TIME) {
            if let Some(path) = &sensor.io {
                let value = f64::from(u8::from(detects != sensor.is_inverted));
                self.writes.push(SignalWrite { path: path.clone(), value });
            }
        }
        let is_event = has_changed && (before.is_some() || detected.is_some());
        is_event.then(|| HandlingEvent::Sensor { sensor: sensor.name.clone(), detects: detected })
    }

    /// Returns the name of the first detected body.
    fn detected(&self, sensor: &Sensor, view: &HandlingView<'_>) -> Option<String> {
        let zone = PlacedZone::new(&sensor.shape, view.place(&sensor.carrier)? * sensor.pose);
        let mut candidates = view.scene.bodies.iter().filter(|body| match &sensor.detects {
            Detects::Parts => matches!(body.carrier, BodyCarrier::Part(_)),
            Detects::Named(names) => names.iter().any(|matcher| is_named(matcher, &body.name)),
        });
        candidates.find(|body| self.is_within(&zone, body, view)).map(|body| body.name.clone())
    }

    /// Whether a body overlaps the zone. A part is compared by its shapes, not by its cores, which are smaller.
    fn is_within(&self, zone: &PlacedZone<'_>, body: &Body, view: &HandlingView<'_>) -> bool {
        let Some(pose) = view.body(body.carrier, &self.parts) else { return false };
        let BodyCarrier::Part(number) = body.carrier else {
            return body.shapes.iter().any(|(shape, own)| zone.overlaps(shape, &(pose * own)));
        };
        let part = view.scene.cell().parts.get(number);
        part.is_some_and(|part| part.solids.iter().any(|solid| zone.overlaps(&solid.shape, &(pose * solid.pose))))
    }
}

/// Beam or zone of a sensor at its pose in `world`.
struct PlacedZone<'z> {
    shape: &'z Shape,
    pose: IsometryMatrix3<f64>,
    bounds: Bounds,
}

impl<'z> PlacedZone<'z> {
    fn new(shape: &'z Shape, pose: IsometryMatrix3<f64>) -> Self {
        Self { shape, pose, bounds: shape.bounds(&pose) }
    }

    /// Whether the zone overlaps a shape at a pose in `world`.
    fn overlaps(&self, shape: &Shape, pose: &IsometryMatrix3<f64>) -> bool {
        let (zone, body) = (PlacedShape { shape: self.shape, pose: &self.pose }, PlacedShape { shape, pose });
        self.bounds.distance(&shape.bounds(pose)) <= 0.0 && matches!(nearest(zone, body, 0.0), Nearness::Overlap(_))
    }
}
