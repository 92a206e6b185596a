//! Message `scene`: the constant content of a run.

use val3_lang::types::BaseType;
use val3_machine::controller::Controller;
use val3_motion::MotionPhase;

use crate::positions::{self, PositionComputer};
use crate::samples::limit_names;
use crate::wire::{Role, Scene};
use crate::{arm, cell, signals};

/// Version of the message format.
const VERSION: u32 = 1;

/// Motion phases, by their numbers in samples.
const PHASES: [MotionPhase; 7] = [
    MotionPhase::Nominal,
    MotionPhase::Blend,
    MotionPhase::Alter,
    MotionPhase::Connection,
    MotionPhase::Compliant,
    MotionPhase::Stopping,
    MotionPhase::Waiting,
];

/// First message for a page: the application, its arm, positions and signals.
#[must_use]
pub fn scene(controller: &Controller, role: Role) -> Scene {
    let data = positions::data(controller);
    let mut positions = PositionComputer::new(&data, controller);
    let mut of_type = |base| positions.of_type(base);
    let names = positions::names_by_signal(&data, controller);
    let watch = controller.devices.state.watch.as_ref();
    Scene {
        version: VERSION,
        role,
        application: controller.name().to_owned(),
        arm: arm::description(controller.arm().model(), !controller.arm().is_chosen(), &controller.devices.shapes),
        base: [0; 6],
        length_unit: controller.length_unit().into(),
        objects: watch.map(|watch| cell::objects(watch.scene().cell())).unwrap_or_default(),
        parts: watch.map(|watch| cell::parts(watch.scene().cell())).unwrap_or_default(),
        frames: of_type(BaseType::Frame),
        tools: of_type(BaseType::Tool),
        points: of_type(BaseType::Point),
        joints: positions::joints(&data, &controller.vm.space.memory),
        signals: signals::described(&controller.devices.state.io, &names),
        lines: signals::lines(controller),
        phases: PHASES.map(|phase| phase.word().to_owned()).to_vec(),
        limits: limit_names(),
    }
}
