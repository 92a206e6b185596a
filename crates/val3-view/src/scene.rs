//! Message `scene`: the constant content of a run.

use serde_json::{Value, json};
use val3_lang::types::BaseType;
use val3_machine::controller::Controller;
use val3_motion::MotionPhase;

use crate::positions::{self, Positions};
use crate::samples::limit_names;
use crate::{arm, signals};

/// Version of the messages.
const VERSION: u32 = 1;

/// The phases of motion by their numbers in samples.
const PHASES: [MotionPhase; 7] = [
    MotionPhase::Nominal,
    MotionPhase::Blend,
    MotionPhase::Alter,
    MotionPhase::Connection,
    MotionPhase::Compliant,
    MotionPhase::Stopping,
    MotionPhase::Waiting,
];

/// First message for a page: the application, its arm, positions and signals. `role` is the reader's role.
#[must_use]
pub fn scene(controller: &Controller, role: &str) -> Value {
    let data = positions::data(controller);
    let mut positions = Positions::new(&data, &controller.vm.space.memory);
    let mut of_type = |base| positions.of_type(base);
    let names = positions::names_by_signal(&data, controller);
    json!({
        "kind": "scene",
        "version": VERSION,
        "role": role,
        "application": controller.name(),
        "arm": arm::description(controller.devices.state.arm.model(), &controller.devices.shapes),
        "base": [0, 0, 0, 0, 0, 0],
        "frames": of_type(BaseType::Frame),
        "tools": of_type(BaseType::Tool),
        "points": of_type(BaseType::Point),
        "joints": of_type(BaseType::Joint),
        "signals": signals::described(&controller.devices.state.io, &names),
        "lines": signals::lines(controller),
        "phases": PHASES.map(MotionPhase::word),
        "limits": limit_names(),
    })
}
