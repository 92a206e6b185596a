//! The controller of an application: that of its cell, as a `val3.toml` and the arguments say. Every command that
//! executes opens it here, so that all see the same world.

use std::sync::Arc;

use val3_analysis::db::{Database, Project};
use val3_bytecode::Image;
use val3_lang::components::Component;
use val3_machine::controller::Controller;
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
    cell::describe(&mut devices, &disk);
    describe(&mut devices, args);
    settings.apply(&mut devices);
    lines::connect(&mut devices.lines, &disk, tape, &settings)?;
    Ok(Controller::new(devices, image, application, settings.line_cost))
}

/// What the arguments say of the arm, and the date.
fn describe(devices: &mut Devices, args: &ControllerArgs) {
    // Kinds of arms have no digit, models have.
    if let Some(model) = args.arm.as_ref().filter(|name| name.contains(|letter: char| letter.is_ascii_digit())) {
        devices.versions.set(Component::ArmType, model);
    }
    if let Some(date) = args.date {
        devices.calendar = date;
    }
}
