//! Sensors: detected bodies, and changes of their inputs.

use std::collections::VecDeque;

use val3_collision::{Nearness, PlacedShape, nearest};

use super::{Handling, HandlingEvent, HandlingView, SAME_TIME};
use crate::allowed::is_named;
use crate::gripper::SignalWrite;
use crate::scene::BodyCarrier;
use crate::sensor::{Detects, Sensor};

/// State of a sensor.
#[derive(Debug, Clone, Default)]
pub(super) struct SensorState {
    /// Whether it detects something; `None` before the first cycle.
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
    /// Evaluates a sensor.
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

    /// Name of the first detected body.
    fn detected(&self, sensor: &Sensor, view: &HandlingView<'_>) -> Option<String> {
        let place = view.place(&sensor.carrier)? * sensor.pose;
        let bodies = view.scene.bodies.iter();
        let found = bodies.filter(|body| match &sensor.detects {
            Detects::Parts => matches!(body.carrier, BodyCarrier::Part(_)),
            Detects::Named(names) => names.iter().any(|matcher| is_named(matcher, &body.name)),
        });
        let bounds = sensor.shape.bounds(&place);
        let mut found = found.filter(|body| {
            let Some(pose) = view.body(body.carrier, &self.parts) else { return false };
            let touches = |shape: &val3_collision::Shape, own: &val3_geometry::IsometryMatrix3<f64>| {
                let pose = pose * own;
                let (first, second) =
                    (PlacedShape { shape: &sensor.shape, pose: &place }, PlacedShape { shape, pose: &pose });
                bounds.distance(&shape.bounds(&pose)) <= 0.0
                    && matches!(nearest(first, second, 0.0), Nearness::Overlap(_))
            };
            match body.carrier {
                BodyCarrier::Part(number) => {
                    let solids = view.scene.cell().parts.get(number).map(|part| &part.solids);
                    solids.into_iter().flat_map(|solids| solids.iter()).any(|solid| touches(&solid.shape, &solid.pose))
                }
                _ => body.shapes.iter().any(|(shape, own)| touches(shape, own)),
            }
        });
        found.next().map(|body| body.name.clone())
    }
}
