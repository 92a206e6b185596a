//! Things around the arm: where they are, and what comes too near to them.

use std::sync::Arc;

use val3_cell::{Carrier, Cell, DataKind, Encounter, Handling, Scene, Sight, Watch};
use val3_geometry::IsometryMatrix3;
use val3_lang::call::ToolRef;
use val3_lang::ports::Time;
use val3_lang::references;
use val3_lang::types::BaseType;

use super::Controller;
use crate::arm::{CurrentMove, MoveOrigin};
use crate::event::{ClearanceMove, EventKind, seconds};

impl Controller {
    /// Returns whether a datum is a frame or a tool; `None` if it is neither, or does not exist.
    #[must_use]
    pub fn carrier_kind(&self, name: &str) -> Option<DataKind> {
        match self.variable(name)? {
            (_, BaseType::Frame) => Some(DataKind::Frame),
            (_, BaseType::Tool) => Some(DataKind::Tool),
            _ => None,
        }
    }

    /// Places a cell around the arm, and watches the distances from now on.
    pub fn surround(&mut self, cell: Cell) {
        let arm = Arc::clone(self.devices.state.arm.shared_model());
        let has_handling = !(cell.parts.is_empty() && cell.grippers.is_empty() && cell.sensors.is_empty());
        let scene = Scene::new(cell.into(), arm);
        self.devices.state.handling = has_handling.then(|| Handling::new(&scene));
        self.devices.state.watch = Some(Watch::new(scene));
    }

    /// Returns where the arm and the frames and tools of a scene are, at a time in seconds.
    #[must_use]
    pub fn sight(&self, scene: &Scene, time: f64) -> Sight<'_> {
        let arm = &self.devices.state.arm;
        Sight {
            arm: arm.shared_model(),
            joints: arm.joint(),
            placement: arm.placements(),
            places: scene.data().map(|carrier| self.place_of(carrier)).collect(),
            parts: self
                .devices
                .state
                .handling
                .as_ref()
                .map(|handling| Arc::clone(handling.parts()))
                .unwrap_or_default(),
            time,
        }
    }

    /// Pose of a frame in `world` or of a tool in `flange`; `None` for other carriers, and without a father.
    fn place_of(&self, carrier: &Carrier) -> Option<IsometryMatrix3<f64>> {
        match carrier {
            Carrier::Frame(name) => self.frame_in_world(name),
            Carrier::Tool(name) => self.tool_in_flange(name),
            Carrier::World | Carrier::Link(_) | Carrier::Flange => None,
        }
    }

    /// Current pose of a tool in `flange`, in mm, by name. `None` if the tool does not exist or has no father.
    fn tool_in_flange(&self, name: &str) -> Option<IsometryMatrix3<f64>> {
        let (place, _) = self.variable(name).filter(|(_, base)| *base == BaseType::Tool)?;
        let way = references::of_tool(&self.vm.space.memory, ToolRef(place)).ok()?;
        Some(references::in_millimetres(&way, self.length_unit()))
    }

    /// Watches the distances at the beginning of a cycle.
    pub(super) fn watch_surroundings(&mut self, now: Time) {
        let Some(mut watch) = self.devices.state.watch.take() else { return };
        let scene = Arc::clone(watch.scene());
        let label = self.devices.state.arm.current_move();
        let encounters = watch.see(&self.sight(&scene, seconds(now)), &label);
        self.devices.state.watch = Some(watch);
        self.record_encounters(now, encounters);
    }

    /// Ends all encounters at the end of a run, and notes the things whose distances were unknown.
    pub fn end_encounters(&mut self) {
        for text in self.unplaced_things().into_iter().chain(self.uncontrolled_grippers()) {
            self.devices.record_outside(self.now(), EventKind::Notice { text });
        }
        let encounters = self.devices.state.watch.as_mut().map(Watch::finish).unwrap_or_default();
        self.record_encounters(self.now(), encounters);
    }

    /// States which things had no place while the arm moved; `None` if all had one.
    #[must_use]
    pub fn unplaced_things(&self) -> Option<String> {
        let watch = self.devices.state.watch.as_ref()?;
        let names: Vec<String> = watch.unplaced().map(|name| format!("`{name}`")).collect();
        let names = (!names.is_empty()).then(|| names.join(", "))?;
        Some(format!(
            "the distances of {names} were unknown while the arm moved: the frame or tool had no father, or impossible values"
        ))
    }

    fn record_encounters(&mut self, now: Time, encounters: Vec<Encounter<Option<CurrentMove>>>) {
        for Encounter { state, names: [a, b], measured, time, joints, label, at_start } in encounters {
            let axes = self.devices.state.arm.model().axes();
            let of = label.filter(|_| !at_start).map(|(id, MoveOrigin { instruction, at, .. })| {
                let (program, line, file) = self.devices.place_of_move(at);
                ClearanceMove { id, instruction, program, line, file }
            });
            let kind = EventKind::Clearance {
                state: state.word(),
                a,
                b,
                distance: measured.distance,
                points: measured.points.map(Into::into),
                at: time,
                joints: joints.iter().take(axes).copied().collect(),
                start: at_start,
                of,
            };
            self.devices.record_outside(now, kind);
        }
    }
}
