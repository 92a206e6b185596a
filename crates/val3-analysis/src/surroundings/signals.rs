//! Inputs and outputs that an application can use.

use std::collections::BTreeMap;

use smol_str::SmolStr;
use val3_cell::{KnownSignal, SignalClass};
use val3_lang::io_paths::is_output;
use val3_lang::suggest::nearest;
use val3_lang::types::BaseType;

use crate::cell::CellIo;
use crate::db::{Db, Project};
use crate::items::input_links::links;
use crate::items::manifest::manifest;
use crate::items::project::data_files;

/// Inputs and outputs of an application: the signals in the configuration of the cell, and the links of its data.
pub(super) struct Signals {
    /// Kinds of signals by path.
    known: BTreeMap<String, SignalClass>,
    /// Paths by the names in the configuration.
    names: BTreeMap<SmolStr, SmolStr>,
    /// Configured devices, which have no other signals.
    devices: Vec<String>,
    /// Whether libraries may link further signals.
    is_open: bool,
}

impl Signals {
    pub(super) fn of(db: &dyn Db, project: Project) -> Self {
        let io = project.cell(db).map(|cell| &cell.config(db).io);
        let mut known = BTreeMap::new();
        for file in data_files(db, project) {
            let linked = links(db, *file).into_iter();
            known.extend(linked.map(|link| (link.text.to_string(), class(link.ty))));
        }
        known.extend(io.into_iter().flat_map(configured));
        let names = io.into_iter().flat_map(|io| &io.names);
        let names = names.map(|(name, path)| (name.clone(), path.clone())).collect();
        let devices = io.into_iter().flat_map(|io| io.devices.keys()).cloned().collect();
        let is_open = !manifest(db, project.manifest(db)).projects().is_empty();
        Self { known, names, devices, is_open }
    }

    /// Returns a signal by path or name. A path without a device (`valve1`) finds the signal with this address in any
    /// device.
    ///
    /// # Errors
    /// There is no such signal, and no library can add it; a similar path or name, if one exists.
    pub(super) fn find(&self, text: &str) -> Result<KnownSignal, Option<String>> {
        let path = self.names.get(text).map_or(text, SmolStr::as_str);
        let is_address = !path.contains('\\');
        let address = |known: &str| known.rsplit('\\').next() == Some(path);
        let found = self.known.get_key_value(path).or_else(|| {
            let mut known = self.known.iter().filter(|_| is_address);
            known.find(|(known, _)| address(known))
        });
        if let Some((path, class)) = found {
            return Ok(KnownSignal { class: *class, is_output: is_output(path) });
        }
        let is_configured = path.split_once('\\').is_some_and(|(device, _)| self.devices.iter().any(|it| it == device));
        if self.is_open && !is_configured {
            return Ok(KnownSignal { class: SignalClass::Unknown, is_output: is_output(path) });
        }
        let names = self.names.keys().map(SmolStr::as_str);
        Err(nearest(text, self.known.keys().map(String::as_str).chain(names)).map(str::to_owned))
    }
}

/// Returns the paths of the digital and analog signals that an application can use, with the type of data that are
/// linked to them: the signals in the configuration of the cell, and the links of the application's data.
pub fn signal_paths(db: &dyn Db, project: Project) -> Vec<(String, BaseType)> {
    let known = Signals::of(db, project).known.into_iter();
    let paths = known.filter_map(|(path, class)| match class {
        SignalClass::Digital => Some((path, BaseType::Dio)),
        SignalClass::Analog => Some((path, BaseType::Aio)),
        SignalClass::Unknown => None,
    });
    paths.filter(|(path, _)| !path.is_empty()).collect()
}

/// Inputs and outputs in the configuration, by path.
fn configured(io: &CellIo) -> impl Iterator<Item = (String, SignalClass)> {
    io.devices.iter().flat_map(|(device, signals)| {
        let signals = signals.iter().filter(|(_, ty)| matches!(ty, BaseType::Dio | BaseType::Aio));
        signals.map(move |(name, ty)| (format!("{device}\\{name}"), class(*ty)))
    })
}

/// Kind of a signal to which data of this type are linked. The output of a tool is digital.
fn class(ty: BaseType) -> SignalClass {
    match ty {
        BaseType::Dio | BaseType::Tool => SignalClass::Digital,
        BaseType::Aio => SignalClass::Analog,
        _ => SignalClass::Unknown,
    }
}
