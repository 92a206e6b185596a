//! Files of a cell that describe its controller: inputs and outputs, arm and language.

use camino::Utf8Path;
use val3_analysis::db::{Database, Project};
use val3_analysis::items::project::items;
use val3_files::{FileClass, Unreadable};
use val3_lang::versions::Version;
use val3_machine::devices::Devices;
use val3_machine::io::{Direction, IoTable, Signal, SignalKind, SignalRange};
use val3_modbus::file::Topic;
use val3_modbus::{DEVICE, Element, ModbusFile, TableKind, Writer};
use val3_syntax::document;

use crate::arm::ChosenArm;
use crate::error::SessionError;

/// Sets the version of the controller to the version of the cell. Without a cell, a newer version that the project
/// declares replaces the default, because an older controller rejects the application.
pub(crate) fn set_version(devices: &mut Devices, db: &Database, project: Project) {
    let declared = Some(items(db, project).version).filter(|declared| *declared > Version::DEFAULT);
    let version = project.cell(db).and_then(|cell| cell.config(db).version).or(declared);
    if let Some(version) = version {
        devices.state.versions.set_language(version);
    }
}

/// Declares the inputs and outputs in the cell's configuration.
pub(crate) fn declare_io(devices: &mut Devices, db: &Database, project: Project) {
    let Some(cell) = project.cell(db) else { return };
    let known = &cell.config(db).io;
    let modbus = known.modbus.as_ref().map(|file| ModbusFile::read(&file.text)).filter(ModbusFile::has_all_items);
    for (device, signals) in &known.devices {
        if let Some(file) = modbus.as_ref().filter(|_| device == DEVICE) {
            let elements = file.topics.iter().flat_map(Topic::elements);
            elements.for_each(|element| declare_element(&mut devices.state.io, element));
            continue;
        }
        let mut signals: Vec<_> = signals.iter().map(|(name, base)| (name.as_str(), *base)).collect();
        signals.sort_unstable_by_key(|(name, _)| *name);
        devices.state.io.declare_device(device, signals);
    }
    for (name, path) in &known.names {
        devices.state.io.name_signal(name, path);
    }
}

/// Declares a value of the Modbus server, whose direction is in the file. Words may have any number, because scripts set
/// measured values; the server rounds them.
fn declare_element(io: &mut IoTable, Element { table, writer, link, other_links, .. }: Element) {
    other_links.iter().for_each(|other| io.name_signal(other, &link));
    io.declare(Signal {
        path: link,
        description: String::new(),
        kind: match table {
            TableKind::Bits => SignalKind::Digital,
            TableKind::Words => SignalKind::Analog(SignalRange::Float),
        },
        direction: match writer {
            Writer::Client => Direction::Input,
            Writer::Robot => Direction::Output,
        },
        protected: false,
    });
}

/// Sets the controller's arm and language from the cell around `disk`; the arm in `chosen` has precedence.
///
/// # Errors
/// If a file of the cell cannot be read.
pub(crate) fn describe(devices: &mut Devices, disk: &Utf8Path, chosen: Option<ChosenArm>) -> Result<(), SessionError> {
    if let Some(ChosenArm { model, name }) = chosen {
        devices.state.set_arm(model, &name);
    }
    for name in ["arm.cfx", "cell.cfx"] {
        if let Some(text) = config(disk, name)? {
            devices.describe(&text);
        }
    }
    Ok(())
}

/// Text of a file in `usr/configs` of the cell around `disk`; `None` if it does not exist.
///
/// # Errors
/// If the file exists but cannot be read.
pub(crate) fn config(disk: &Utf8Path, name: &str) -> Result<Option<String>, SessionError> {
    let Some(usr) = disk.parent() else { return Ok(None) };
    let file = usr.join("configs").join(name);
    let text = match val3_files::read(&file, FileClass::Cell) {
        Ok(bytes) => document::text(bytes).map_err(|fault| fault.to_string()),
        Err(Unreadable::Missing) => return Ok(None),
        Err(reason) => Err(reason.to_string()),
    };
    text.map(Some).map_err(|reason| SessionError::UnreadableFile { file, reason })
}
