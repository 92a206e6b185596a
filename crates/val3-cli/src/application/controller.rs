//! The controller of an application: that of its cell, as a `val3.toml` and the arguments say. Every command that
//! executes opens it here, so that all see the same world.

use std::sync::Arc;

use val3_analysis::db::{Database, Project};
use val3_analysis::items::project::items;
use val3_bytecode::Image;
use val3_lang::memory::MEMORY;
use val3_lang::types::Arm;
use val3_machine::controller::Controller;
use val3_machine::controller_state::{FIRST_ARM, JointLimits};
use val3_machine::devices::Devices;

use super::lines::Tape;
use super::settings::Settings;
use super::{Images, Media, cell, lines};
use crate::args::ControllerArgs;
use crate::user_error::UserError;

/// A controller with the application in memory, and the cell around it.
///
/// # Errors
/// A setting is at fault, or a folder or line cannot be opened.
pub(crate) fn controller(
    args: &ControllerArgs,
    tape: Tape<'_>,
    (db, project): (&Database, Project),
    image: Arc<Image>,
) -> Result<Controller, UserError> {
    let settings = Settings::of(args, project.configuration(db).map(|configuration| configuration.file(db)))?;
    let mut media = Media::of(db, project)?;
    settings.roots.iter().try_for_each(|root| media.mount(&root.name, &root.folder))?;
    let Media { roots, disk, application } = media;
    let mut devices = Devices::new(roots, Box::new(Images::new(disk.clone())));
    cell::declare_io(&mut devices, db, project);
    if items(db, project).arm.is_some_and(|arm| arm != Arm::from_model(FIRST_ARM)) {
        // The limits of the first arm are those of another kind.
        devices.state.arm.limits = JointLimits::NONE;
    }
    cell::describe(&mut devices, &disk);
    describe(&mut devices, args);
    settings.apply(&mut devices);
    lines::connect(&mut devices.lines, &disk, tape, &settings)?;
    Controller::new(devices, image, application, settings.line_cost).map_err(|_| {
        let megabytes = MEMORY >> 20;
        UserError::new(format!("the data of the application need more memory than a controller has ({megabytes} MB)"))
            .with_help("make arrays smaller, or read what is large from files")
    })
}

/// What the arguments say of the arm, and the date.
fn describe(devices: &mut Devices, args: &ControllerArgs) {
    // Kinds of arms have no digit, models have.
    if let Some(model) = args.arm.as_ref().filter(|name| name.contains(|letter: char| letter.is_ascii_digit())) {
        devices.set_arm(model);
    }
    if let Some(date) = args.date {
        devices.state.calendar = date;
    }
}
