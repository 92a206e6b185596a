//! Opens an application's controller, with the cell's devices and the settings from the caller and `val3.toml`.

use std::sync::Arc;

use val3_analysis::db::{Database, Project};
use val3_analysis::items::project::{folder, items};
use val3_analysis::paths::path_key;
use val3_bytecode::Image;
use val3_lang::types::Arm;
use val3_machine::controller::Controller;
use val3_machine::devices::Devices;

use crate::connection::{self, Tape};
use crate::error::SessionError;
use crate::libraries::LibraryCompiler;
use crate::media::CellMedia;
use crate::settings::{ControllerSettings, MergedSettings};
use crate::stand_ins::StandIn;
use crate::{add_on_programs, arm, cell, pages, shapes, surroundings};

/// Opens the controller with the application's image in memory. Stand-ins are loaded in place of libraries.
pub(crate) fn open(
    db: &Database,
    project: Project,
    stand_ins: &[StandIn],
    settings: &ControllerSettings,
    tape: Tape<'_>,
    image: Arc<Image>,
) -> Result<Controller, SessionError> {
    let file = project.configuration(db).map(|configuration| configuration.file(db));
    let merged = MergedSettings::of(settings, file)?;
    let mut media = CellMedia::of(db, project)?;
    merged.roots.iter().try_for_each(|root| media.mount(&root.name, &root.folder))?;
    let mut replaced = media.place_stand_ins(db, stand_ins)?;
    media.place_add_ons(db, &add_on_programs::libraries(db)?, &mut replaced)?;
    let CellMedia { roots, disk, application, outside } = media;
    // Stand-ins belong to the tests, so they are not counted.
    let key = |stand_in: &StandIn| path_key(stand_in.project.manifest(db).path(db).as_str());
    let uncounted = stand_ins.iter().map(key).collect();
    let compiler = LibraryCompiler::new(disk.clone(), outside, settings.form, uncounted).with(settings.edited.clone());
    let mut devices = Devices::new(roots, Box::new(compiler));
    devices.stand_ins = replaced;
    cell::set_version(&mut devices, db, project);
    cell::declare_io(&mut devices, db, project);
    devices.state.pendant.set_html_pages(pages::of(db, project));
    if items(db, project).arm == Some(Arm::Scara) {
        devices.state.set_default_arm(true);
    }
    let chosen = arm::chosen(settings.arm.as_deref(), file)?;
    cell::describe(&mut devices, &disk, chosen)?;
    if let Some(date) = settings.date {
        devices.state.calendar = date;
    }
    merged.apply(&mut devices)?;
    if let Some(file) = file {
        devices.shapes = shapes::read(file, devices.state.arm.model())?;
    }
    connection::connect(&mut devices.lines, &disk, tape, &merged)?;
    let controller = Controller::new(devices, image, application, merged.line_cost);
    let mut controller = controller.map_err(|_| SessionError::Memory)?;
    connection::check_names(&settings.connections, &merged.configured_lines, db, &disk, &controller)?;
    surroundings::place(&mut controller, settings.cell.as_ref(), file, folder(db, project))?;
    Ok(controller)
}
