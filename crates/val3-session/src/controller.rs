//! The controller of an application: that of its cell, with the settings of the caller and of `val3.toml`.

use std::sync::Arc;

use val3_analysis::db::{Database, Project};
use val3_analysis::items::project::items;
use val3_bytecode::Image;
use val3_lang::types::Arm;
use val3_machine::arm::JointLimits;
use val3_machine::controller::Controller;
use val3_machine::controller_state::FIRST_ARM;
use val3_machine::devices::Devices;

use crate::cell;
use crate::connection::{self, Tape};
use crate::error::SessionError;
use crate::libraries::LibraryCompiler;
use crate::media::Media;
use crate::settings::{ControllerSettings, MergedSettings};

/// Opens the controller, with the image of the application in memory.
pub(crate) fn open(
    db: &Database,
    project: Project,
    settings: &ControllerSettings,
    tape: Tape<'_>,
    image: Arc<Image>,
) -> Result<Controller, SessionError> {
    let merged = MergedSettings::of(settings, project.configuration(db).map(|configuration| configuration.file(db)))?;
    let mut media = Media::of(db, project)?;
    merged.roots.iter().try_for_each(|root| media.mount(&root.name, &root.folder))?;
    let Media { roots, disk, application } = media;
    let mut devices = Devices::new(roots, Box::new(LibraryCompiler::new(disk.clone())));
    cell::declare_io(&mut devices, db, project);
    if items(db, project).arm.is_some_and(|arm| arm != Arm::from_model(FIRST_ARM)) {
        // The default joint limits are those of another kind of arm.
        devices.state.arm.limits = JointLimits::NONE;
    }
    cell::describe(&mut devices, &disk);
    describe(&mut devices, settings);
    merged.apply(&mut devices);
    connection::connect(&mut devices.lines, &disk, tape, &merged)?;
    Controller::new(devices, image, application, merged.line_cost).map_err(|_| SessionError::Memory)
}

/// Sets the arm and the date.
fn describe(devices: &mut Devices, settings: &ControllerSettings) {
    // Names of models contain digits, names of kinds of arms do not.
    if let Some(model) = settings.arm.as_ref().filter(|name| name.contains(|letter: char| letter.is_ascii_digit())) {
        devices.set_arm(model);
    }
    if let Some(date) = settings.date {
        devices.state.calendar = date;
    }
}
