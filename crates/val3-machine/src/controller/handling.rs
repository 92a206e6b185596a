//! Parts, grippers, sensors and conveyors of a cell.

use std::sync::Arc;

use val3_cell::{
    Carrier, CellOutputs, Gripper, GripperCommand, GripperControl, HandlingEvent, KnownSignal, NearPart, Part,
    PartHolder, PartPlace, Scene, SignalClass, SignalWrite,
};
use val3_geometry::IsometryMatrix3;
use val3_lang::call::StoredValue;
use val3_lang::io_paths::is_output;
use val3_lang::memory::LinkPlace;
use val3_lang::ports::{Time, nanoseconds};
use val3_lang::types::BaseType;
use val3_vm::CYCLE;

use super::Controller;
use crate::controller_state::MessageSeverity;
use crate::event::{EventKind, seconds};
use crate::io::{LinkId, SignalKind};

/// A part, and where it is.
#[derive(Debug, Clone, PartialEq)]
pub struct PartState {
    /// Its name.
    pub name: String,
    /// `world`, a frame, or the flange if a gripper holds it; `None` if it was removed.
    pub carrier: Option<Carrier>,
    /// Pose of the part in the frame of the carrier.
    pub pose: IsometryMatrix3<f64>,
}

impl PartState {
    fn new(part: &Part, place: &PartPlace, scene: &Scene) -> Self {
        let carrier = match place.holder {
            PartHolder::World => Some(Carrier::World),
            PartHolder::Frame(number) => scene.data().nth(number).cloned(),
            PartHolder::Gripper(_) => Some(Carrier::Flange),
            PartHolder::Gone => None,
        };
        Self { name: part.name.clone(), carrier, pose: place.pose }
    }
}

impl Controller {
    /// Returns a signal by path or name. The error is a similar path or name, if one exists.
    ///
    /// # Errors
    /// There is no such signal, and no library can add it.
    pub fn known_signal(&self, path: &str) -> Result<KnownSignal, Option<String>> {
        let io = &self.devices.state.io;
        let signal = io.find(path).and_then(|id| io.signal(id));
        let class = match signal.map(|signal| signal.kind) {
            Some(SignalKind::Digital) => SignalClass::Digital,
            Some(SignalKind::Analog(_)) => SignalClass::Analog,
            None => match self.signal_misfit(path) {
                None => SignalClass::Unknown,
                Some(misfit) => return Err(misfit.proposal()),
            },
        };
        Ok(KnownSignal { class, is_output: is_output(signal.map_or(path, |signal| &signal.path)) })
    }

    /// Evaluates grippers and sensors before the first cycle, and sets their inputs at the beginning of each cycle.
    /// Scripts take precedence, because they follow.
    pub(super) fn begin_handling(&mut self, now: Time) {
        if self.devices.state.handling.as_ref().is_some_and(|handling| !handling.has_begun()) {
            self.handle_parts(now);
        }
        let writes = self.devices.state.handling.as_mut().map(val3_cell::Handling::take_writes);
        for SignalWrite { path, value } in writes.into_iter().flatten() {
            let io = &mut self.devices.state.io;
            if let Some(id) = io.find(&path) {
                io.set(id, value);
            }
        }
    }

    /// Follows the outputs of grippers, and evaluates sensors, at the end of a cycle.
    pub(super) fn handle_parts(&mut self, now: Time) {
        let Some(scene) = self.cell_scene() else { return };
        let Some(mut handling) = self.devices.state.handling.take() else { return };
        let outputs = CellOutputs {
            grippers: scene.cell().grippers.iter().map(|gripper| self.command(gripper)).collect(),
            conveyors: scene.cell().conveyors.iter().map(|conveyor| self.have_values(&conveyor.when)).collect(),
        };
        if handling.is_idle(&outputs, seconds(now)) {
            self.devices.state.handling = Some(handling);
            return;
        }
        let mut sight = self.sight(&scene, seconds(now));
        sight.parts = Arc::clone(handling.parts());
        let events = handling.see(&scene, &sight, &outputs, seconds(CYCLE));
        self.devices.state.handling = Some(handling);
        events.into_iter().for_each(|event| self.devices.record_outside(now, event_kind(event)));
    }

    /// Time of the next change of a gripper or sensor without an external cause.
    pub(super) fn next_handling(&self) -> Option<Time> {
        let due = self.devices.state.handling.as_ref()?.next_due()?;
        Some(nanoseconds(due).max(self.now()))
    }

    /// State of a gripper's output; `None` if it has no output.
    fn command(&self, gripper: &Gripper) -> Option<GripperCommand> {
        let io = &self.devices.state.io;
        match &gripper.control {
            GripperControl::Tool { tool, holds_when_open } => {
                let (place, _) = self.variable(&format!("{tool}.gripper"))?;
                let LinkPlace::Port(port) = self.vm.space.memory.link(place, 0).ok()? else { return None };
                let is_open = io.hardware(io.target_of(LinkId::from_number(port))?)? != 0.0;
                let time = if is_open { "otime" } else { "ctime" };
                let delay = self.number(&format!("{tool}.{time}")).filter(|time| time.is_finite()).unwrap_or_default();
                Some(GripperCommand { holds: is_open == *holds_when_open, delay: delay.max(0.0) })
            }
            GripperControl::Signals(values) => Some(GripperCommand { holds: self.have_values(values)?, delay: 0.0 }),
        }
    }

    /// Whether all signals have these values; `None` without one of the signals.
    fn have_values(&self, values: &[SignalWrite]) -> Option<bool> {
        let io = &self.devices.state.io;
        let mut have_values = true;
        for SignalWrite { path, value } in values {
            have_values &= io.hardware(io.find(path)?)? == *value;
        }
        Some(have_values)
    }

    fn number(&self, path: &str) -> Option<f64> {
        let (place, base) = self.variable(path)?;
        if base == BaseType::Num { f64::read(&self.vm.space.memory, place).ok() } else { None }
    }

    /// The cell around the arm.
    pub(crate) fn cell_scene(&self) -> Option<Arc<Scene>> {
        self.devices.state.watch.as_ref().map(|watch| Arc::clone(watch.scene()))
    }

    /// Names of the parts.
    pub(crate) fn part_names(&self) -> Vec<String> {
        let scene = self.cell_scene();
        scene.iter().flat_map(|scene| scene.cell().parts.iter()).map(|part| part.name.clone()).collect()
    }

    /// Names of the sensors.
    pub(crate) fn sensor_names(&self) -> Vec<String> {
        let scene = self.cell_scene();
        scene.iter().flat_map(|scene| scene.cell().sensors.iter()).map(|sensor| sensor.name.clone()).collect()
    }

    /// Whether a gripper holds a part; `None` without a part of this name.
    pub(crate) fn is_held(&self, part: &str) -> Option<bool> {
        let number = self.cell_scene()?.cell().part(part)?;
        Some(self.devices.state.handling.as_ref()?.is_held(number))
    }

    /// Whether a gripper holds a part.
    #[must_use]
    pub fn is_part_held(&self, part: &str) -> bool {
        self.is_held(part).unwrap_or_default()
    }

    /// Whether a sensor detects something; `None` without a sensor of this name.
    pub(crate) fn is_seen(&self, sensor: &str) -> Option<bool> {
        let scene = self.cell_scene()?;
        let number = scene.cell().sensors.iter().position(|known| known.name == sensor)?;
        Some(self.devices.state.handling.as_ref()?.detects(number))
    }

    /// Pose in `world` of the frame that a part stands in at the start; `None` without a place.
    pub(crate) fn own_frame(&self, part: &str) -> Option<IsometryMatrix3<f64>> {
        let scene = self.cell_scene()?;
        let part = scene.cell().parts.get(scene.cell().part(part)?)?;
        match &part.carrier {
            Carrier::Frame(name) => Some(self.frame_in_world(name)? * part.origin),
            _ => Some(part.origin),
        }
    }

    /// Places a part at a pose in `world`, or removes it.
    pub(crate) fn place_part(&mut self, name: &str, pose: Option<IsometryMatrix3<f64>>, now: Time) {
        let Some((scene, handling)) = self.cell_scene().zip(self.devices.state.handling.as_mut()) else { return };
        let event = scene.cell().part(name).and_then(|part| handling.place(&scene, part, pose));
        event.into_iter().for_each(|event| self.devices.record_outside(now, event_kind(event)));
    }

    /// The parts, in the order of the cell.
    #[must_use]
    pub fn parts(&self) -> Vec<PartState> {
        let Some((scene, handling)) = self.cell_scene().zip(self.devices.state.handling.as_ref()) else {
            return Vec::new();
        };
        let parts = scene.cell().parts.iter().zip(handling.parts().iter());
        parts.map(|(part, place)| PartState::new(part, place, &scene)).collect()
    }

    /// Pose of a part in `world`; `None` if it was removed, does not exist, or stands in a frame without a place.
    #[must_use]
    pub fn part_in_world(&self, name: &str) -> Option<IsometryMatrix3<f64>> {
        let scene = self.cell_scene()?;
        let sight = self.sight(&scene, seconds(self.now()));
        self.devices.state.handling.as_ref()?.part_in_world(&scene, &sight, scene.cell().part(name)?)
    }

    /// Notes once that a script writes an input of a gripper or sensor.
    pub(crate) fn note_script_input(&mut self, path: &str, now: Time) {
        let Some(scene) = self.cell_scene().filter(|_| self.devices.state.handling.is_some()) else { return };
        let io = &self.devices.state.io;
        let Some(id) = io.find(path) else { return };
        let grippers = scene.cell().grippers.iter();
        let of_grippers =
            grippers.flat_map(|gripper| gripper.holding.iter().chain(&gripper.empty)).map(|write| &write.path);
        let mut of_cell = of_grippers.chain(scene.cell().sensors.iter().filter_map(|sensor| sensor.io.as_ref()));
        if !of_cell.any(|own| io.find(own) == Some(id)) || !self.devices.state.written_twice.insert(path.to_owned()) {
            return;
        }
        let text = format!(
            "the script and the cell both write `{path}`: the value of the script stays until the cell's changes"
        );
        self.devices.report(&text, MessageSeverity::Information, now);
    }

    /// Describes the grippers whose tool never had an output; `None` if all had one.
    pub(super) fn uncontrolled_grippers(&self) -> Option<String> {
        let (scene, handling) = self.cell_scene().zip(self.devices.state.handling.as_ref())?;
        let grippers = scene.cell().grippers.iter().enumerate().filter(|(number, _)| !handling.had_output(*number));
        let names: Vec<String> = grippers.map(|(_, gripper)| format!("`{}`", gripper.name)).collect();
        let names = (!names.is_empty() && handling.has_begun()).then(|| names.join(", "))?;
        Some(format!("nothing controlled the gripper {names}: its tool or signal had no output"))
    }
}

fn event_kind(event: HandlingEvent) -> EventKind {
    match event {
        HandlingEvent::Grip { gripper, part, nearest, within } => {
            let (nearest, distance) = nearest.map(|NearPart { name, distance }| (name, distance)).unzip();
            EventKind::Grip { gripper, part, nearest, distance, within }
        }
        HandlingEvent::Release { gripper, part, above } => EventKind::Release { gripper, part, above },
        HandlingEvent::Part { part, is_gone } => {
            EventKind::Part { part, state: if is_gone { "removed" } else { "placed" } }
        }
        HandlingEvent::Sensor { sensor, detects } => EventKind::Sensor { sensor, on: detects.is_some(), detects },
    }
}
