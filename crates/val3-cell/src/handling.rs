//! Parts while an application runs: conveyors and grippers move parts, sensors detect them.
//!
//! [`Handling`] is part of the controller's state. The controller calls [`Handling::see`] when a cycle ends, and writes
//! the values of [`Handling::take_writes`] to the signals when the next cycle begins.

mod below;
mod convey;
mod conveyor_state;
mod grip;
mod senses;

use std::sync::Arc;

use val3_geometry::IsometryMatrix3;

use crate::carriers::Carrier;
use crate::gripper::{GripperCommand, SignalWrite};
use crate::part::{PartHolder, PartPlace};
use crate::scene::{BodyCarrier, Places, Position, Scene};
use crate::step::Sight;

use conveyor_state::{ConveyorState, SAME_TIME};
use grip::GripperState;
pub use grip::NearPart;
use senses::SensorState;

/// Event of a gripper, part or sensor.
#[derive(Debug, Clone, PartialEq)]
pub enum HandlingEvent {
    /// A gripper has closed, with or without a part.
    Grip {
        /// The gripper.
        gripper: String,
        /// The part; `None` if no part is near enough.
        part: Option<String>,
        /// The nearest part that no gripper holds.
        nearest: Option<NearPart>,
        /// Largest distance at which a part is gripped, in mm.
        within: f64,
    },
    /// A gripper has released a part.
    Release {
        /// The gripper.
        gripper: String,
        /// The part.
        part: String,
        /// Height in mm above the body below it; `None` unless the part hangs in the air.
        above: Option<f64>,
    },
    /// A conveyor or a script has placed or removed a part.
    Part {
        /// The part.
        part: String,
        /// Whether it was removed.
        is_gone: bool,
    },
    /// A sensor has begun or ceased to detect something.
    Sensor {
        /// The sensor.
        sensor: String,
        /// Name of a detected body; `None` if nothing is detected.
        detects: Option<String>,
    },
}

/// Signals of a cell's grippers and conveyors at the end of a cycle.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct CellOutputs {
    /// Commands of the grippers, in the order of the cell; `None` if the output does not exist.
    pub grippers: Vec<Option<GripperCommand>>,
    /// Whether each conveyor runs according to its signals, in the order of the cell; `None` if a signal does not
    /// exist.
    pub conveyors: Vec<Option<bool>>,
}

/// State of parts, grippers, sensors and conveyors.
#[derive(Debug, Clone)]
pub struct Handling {
    parts: Arc<Vec<PartPlace>>,
    grippers: Vec<GripperState>,
    sensors: Vec<SensorState>,
    conveyors: Vec<ConveyorState>,
    /// Whether a gripper or a script has moved a part since the last evaluation of the conveyors.
    has_part_moved: bool,
    /// Signal values for the caller to write.
    writes: Vec<SignalWrite>,
    has_begun: bool,
}

impl Handling {
    /// Creates the initial state: each part has the pose of the file or is outside of the cell.
    #[must_use]
    pub fn new(scene: &Scene) -> Self {
        let cell = scene.cell();
        let parts = cell.parts.iter().map(|part| {
            let holder = match scene.carrier(&part.carrier) {
                _ if part.is_outside => PartHolder::Gone,
                BodyCarrier::Frame(number) => PartHolder::Frame(number),
                _ => PartHolder::World,
            };
            PartPlace { holder, pose: part.pose }
        });
        Self {
            parts: Arc::new(parts.collect()),
            grippers: vec![GripperState::default(); cell.grippers.len()],
            sensors: vec![SensorState::default(); cell.sensors.len()],
            conveyors: vec![ConveyorState::default(); cell.conveyors.len()],
            has_part_moved: false,
            writes: Vec::new(),
            has_begun: false,
        }
    }

    /// Returns the holders and poses of the parts, in the order of the cell.
    #[must_use]
    pub fn parts(&self) -> &Arc<Vec<PartPlace>> {
        &self.parts
    }

    /// Whether [`Self::see`] was called.
    #[must_use]
    pub fn has_begun(&self) -> bool {
        self.has_begun
    }

    /// Whether a gripper holds a part.
    #[must_use]
    pub fn is_held(&self, part: usize) -> bool {
        self.parts.get(part).is_some_and(|place| matches!(place.holder, PartHolder::Gripper(_)))
    }

    /// Whether a sensor detects something. The input follows after the delay.
    #[must_use]
    pub fn detects(&self, sensor: usize) -> bool {
        self.sensors.get(sensor).is_some_and(SensorState::detects)
    }

    /// Whether an output has ever commanded a gripper.
    #[must_use]
    pub fn had_output(&self, gripper: usize) -> bool {
        self.grippers.get(gripper).is_some_and(|state| state.is_controlled)
    }

    /// Whether [`Self::see`] at this time in seconds would have no effect, even if the arm or a frame has moved.
    #[must_use]
    pub fn is_idle(&self, outputs: &CellOutputs, time: f64) -> bool {
        self.has_begun
            && self.sensors.is_empty()
            && self.are_grippers_idle(&outputs.grippers)
            && self.are_conveyors_idle(&outputs.conveyors, time)
    }

    /// Whether all grippers have executed their commands.
    fn are_grippers_idle(&self, commands: &[Option<GripperCommand>]) -> bool {
        let mut grippers = self.grippers.iter().zip(commands);
        grippers.all(|(state, command)| command.is_none_or(|command| state.follows(command)))
    }

    /// Whether no conveyor moves a part, starts, stops, or receives a part at this time in seconds.
    fn are_conveyors_idle(&self, runs: &[Option<bool>], time: f64) -> bool {
        let mut conveyors = self.conveyors.iter().zip(runs);
        self.conveyors.is_empty() || !self.has_part_moved && conveyors.all(|(state, runs)| state.is_idle(*runs, time))
    }

    /// Updates conveyors, grippers and sensors at the end of a cycle with this duration in seconds.
    pub fn see(&mut self, scene: &Scene, sight: &Sight<'_>, outputs: &CellOutputs, cycle: f64) -> Vec<HandlingEvent> {
        let position = scene.position(&sight.joints);
        let view = HandlingView { scene, sight, position: &position };
        let mut events = Vec::new();
        self.has_part_moved = false;
        let cycle = if self.has_begun { cycle } else { 0.0 };
        for (number, runs) in outputs.conveyors.iter().enumerate() {
            events.extend(self.convey(number, *runs, cycle, &view));
        }
        for (number, command) in outputs.grippers.iter().enumerate() {
            events.extend(command.and_then(|command| self.command(number, command, &view)));
        }
        for number in 0..self.sensors.len() {
            events.extend(self.sense(number, &view));
        }
        self.has_begun = true;
        events
    }

    /// Places a part at a pose in `world`, or removes it. A gripper that holds the part loses it.
    pub fn place(&mut self, scene: &Scene, part: usize, pose: Option<IsometryMatrix3<f64>>) -> Option<HandlingEvent> {
        let place = Arc::make_mut(&mut self.parts).get_mut(part)?;
        self.has_part_moved = true;
        let lost = if let PartHolder::Gripper(gripper) = place.holder { Some(gripper) } else { None };
        *place = match pose {
            Some(pose) => PartPlace { holder: PartHolder::World, pose },
            None => PartPlace { holder: PartHolder::Gone, pose: place.pose },
        };
        if let Some(gripper) = lost {
            self.lose(gripper, scene);
        }
        let name = scene.cell().parts.get(part)?.name.clone();
        Some(HandlingEvent::Part { part: name, is_gone: pose.is_none() })
    }

    /// Returns the pose of a part in `world`; `None` if the part was removed or its frame has no pose.
    #[must_use]
    pub fn part_in_world(&self, scene: &Scene, sight: &Sight<'_>, part: usize) -> Option<IsometryMatrix3<f64>> {
        let position = scene.position(&sight.joints);
        position.carrier(BodyCarrier::Part(part), Places { data: &sight.places, parts: &self.parts })
    }

    /// Removes and returns the signal values to write at the beginning of the next cycle.
    pub fn take_writes(&mut self) -> Vec<SignalWrite> {
        std::mem::take(&mut self.writes)
    }

    /// Returns the time in seconds of the next change without an external cause; 0 if signal values are pending.
    #[must_use]
    pub fn next_due(&self) -> Option<f64> {
        if !self.writes.is_empty() {
            return Some(0.0);
        }
        if self.has_part_moved && !self.conveyors.is_empty() {
            return Some(0.0);
        }
        let conveyors = self.conveyors.iter().filter_map(ConveyorState::next_due);
        let grippers = self.grippers.iter().filter_map(|state| state.due).chain(conveyors);
        grippers.chain(self.sensors.iter().filter_map(SensorState::next_due)).min_by(f64::total_cmp)
    }
}

/// Poses of the bodies at the end of a cycle.
struct HandlingView<'v> {
    scene: &'v Scene,
    sight: &'v Sight<'v>,
    position: &'v Position,
}

impl HandlingView<'_> {
    /// Returns the pose of a carrier in `world`; `None` if it has no pose.
    fn place(&self, carrier: &Carrier) -> Option<IsometryMatrix3<f64>> {
        self.position.carrier(self.scene.carrier(carrier), self.sight.places())
    }

    /// Returns the pose of a body in `world`, with parts at `parts`.
    fn body(&self, carrier: BodyCarrier, parts: &[PartPlace]) -> Option<IsometryMatrix3<f64>> {
        self.position.carrier(carrier, Places { data: &self.sight.places, parts })
    }
}

#[cfg(test)]
mod tests;
