//! Configuration files of the controller that contains a `usrapp`.

mod devices;

use std::io;
use std::sync::Arc;

use camino::{Utf8Path, Utf8PathBuf};
use val3_files::{FileClass, Unreadable};
use val3_lang::add_on::{AddOnTable, parse_table};
use val3_lang::types::Arm;
use val3_lang::versions::Version;
use val3_syntax::arm_file::ArmFile;
use val3_syntax::{document, version_file};

use crate::cell::{CellConfig, CellIo, CellText, UnreadableCellFile};
use crate::paths::path_key;
use crate::system::System;

/// File of the Modbus server, below `usr`.
const MODBUS: &str = "applicom/modbus/modbus.xml";

/// Folders of EtherCAT masters in `usr/configs`.
const MASTERS: [&str; 2] = ["J206_EtherCAT", "ecat"];

/// Reads `usr/configs` and `usr/app`; `None` if neither exists.
///
/// `known_arm` is the arm set in a `val3.toml`; `actual` returns a path as spelt on the disk.
pub(super) fn read(
    system: &dyn System,
    usr: &Utf8Path,
    known_arm: Option<Arm>,
    actual: impl FnMut(&Utf8Path) -> Option<Utf8PathBuf>,
) -> Option<CellConfig> {
    let mut files = CellFiles { system, usr, actual, unreadable: Vec::new() };
    let tables = files.tables();
    // An EtherCAT master has additional signals.
    let has_master = MASTERS.iter().any(|folder| files.actual_config(folder).is_some());
    let modbus = files.file(MODBUS);
    // The check uses no entry of this file, but a damaged file shows that the backup is incomplete.
    files.config("controller.cfx");
    let arm_file = files.config("arm.cfx");
    let cell_file = files.config("cell.cfx");
    let version = files.config("val3version.xml");
    let version = version.as_deref().and_then(version_file::language).and_then(|text| Version::parse(&text));
    let mut io = devices::read(|name: &str| files.config(name));
    let is_empty =
        arm_file.is_none() && version.is_none() && io.devices.is_empty() && tables.is_empty() && modbus.is_none();
    let named = || ArmFile::read(arm_file.as_deref()?).model.map(|model| Arm::from_model(&model));
    io.tags = io.tags.filter(|_| !has_master);
    if let Some(file) = modbus {
        devices::add_modbus(file, &mut io);
    }
    let arm = known_arm.or_else(named);
    // A cell without a known arm is treated as six-axis.
    let fitting = tables.into_iter().filter(|(of, _)| *of == arm.unwrap_or(Arm::SixAxis));
    let mut add_ons = Vec::new();
    for (_, path) in fitting {
        match named_table(system, &path) {
            Ok(table) => add_ons.push(table),
            Err(reason) => files.add_unreadable(&path, reason),
        }
    }
    let unreadable_files = files.unreadable;
    if is_empty && unreadable_files.is_empty() {
        return None;
    }
    let arm_files = [arm_file, cell_file].iter().flatten().map(|text| ArmFile::read(text)).collect();
    Some(CellConfig { arm, version, arm_files, described_arm: None, add_ons: Arc::new(add_ons), unreadable_files, io })
}

/// Returns the inputs and outputs in the configuration files of a cell. `file` returns the text of a file below `usr`,
/// for example of `configs/bio.cfx`.
pub fn cell_io(mut file: impl FnMut(&str) -> Option<String>) -> CellIo {
    let mut io = devices::read(|name: &str| file(&format!("configs/{name}")));
    if let Some(text) = file(MODBUS) {
        devices::add_modbus(CellText { path: MODBUS.into(), text: text.into() }, &mut io);
    }
    io
}

/// Files below `usr`. Existing files that cannot be read are added to `unreadable`.
struct CellFiles<'a, A> {
    system: &'a dyn System,
    usr: &'a Utf8Path,
    actual: A,
    unreadable: Vec<UnreadableCellFile>,
}

impl<A: FnMut(&Utf8Path) -> Option<Utf8PathBuf>> CellFiles<'_, A> {
    /// Returns the path of a file or folder in `usr/configs` as spelt on the disk; `None` if it does not exist.
    fn actual_config(&mut self, name: &str) -> Option<Utf8PathBuf> {
        (self.actual)(&self.usr.join("configs").join(name))
    }

    /// Returns the text of a file in `usr/configs`; `None` if it does not exist or is unreadable.
    fn config(&mut self, name: &str) -> Option<String> {
        let path = self.actual_config(name)?;
        self.text(&path)
    }

    /// Returns the file with this path in `usr`; `None` if it does not exist or is unreadable.
    fn file(&mut self, path: &str) -> Option<CellText> {
        let path = (self.actual)(&self.usr.join(path))?;
        let text = self.text(&path)?.into();
        Some(CellText { path, text })
    }

    /// Returns the text of a file; `None` if it does not exist or is unreadable.
    fn text(&mut self, path: &Utf8Path) -> Option<String> {
        text(self.system, path).unwrap_or_else(|reason| {
            self.add_unreadable(path, reason);
            None
        })
    }

    /// Returns the add-on tables in `usr/app` with their kinds of arm.
    fn tables(&mut self) -> Vec<(Arm, Utf8PathBuf)> {
        let Some(app) = (self.actual)(&self.usr.join("app")) else { return Vec::new() };
        tables(self.system, &app).unwrap_or_else(|reason| {
            self.add_unreadable(&app, reason.to_string());
            Vec::new()
        })
    }

    fn add_unreadable(&mut self, path: &Utf8Path, reason: String) {
        let path = path.strip_prefix(self.usr).unwrap_or(path).as_str().into();
        self.unreadable.push(UnreadableCellFile { path, reason: reason.into() });
    }
}

/// Reads an add-on's table.
pub(super) fn named_table(system: &dyn System, path: &Utf8Path) -> Result<AddOnTable, String> {
    let bytes = system.read(path, FileClass::Cell).map_err(|error| error.to_string())?;
    let text = document::text(bytes).map_err(|fault| fault.to_string())?;
    parse_table(&text).map_err(|error| error.to_string())
}

/// Returns the text of a file; `None` if it does not exist.
fn text(system: &dyn System, path: &Utf8Path) -> Result<Option<String>, String> {
    match system.read(path, FileClass::Cell) {
        Ok(bytes) => document::text(bytes).map(Some).map_err(|fault| fault.to_string()),
        Err(Unreadable::Missing) => Ok(None),
        Err(reason) => Err(reason.to_string()),
    }
}

/// Returns the kind of arm in the name of a table, for example `val3.Motion.anthro.cfx`.
fn arm_of_table(name: &str) -> Option<Arm> {
    let name = path_key(name);
    let (_, arm) = name.strip_prefix("val3.")?.strip_suffix(".cfx")?.rsplit_once('.')?;
    Arm::from_table_word(arm)
}

/// Returns the add-on tables in a folder with their kinds of arm.
fn tables(system: &dyn System, folder: &Utf8Path) -> io::Result<Vec<(Arm, Utf8PathBuf)>> {
    let names = system.list(folder)?;
    Ok(names.iter().filter_map(|name| Some((arm_of_table(name)?, folder.join(name)))).collect())
}

/// Reads the file that describes an arm.
pub(super) fn described_arm(system: &dyn System, path: &Utf8Path) -> Result<val3_kinematics::Arm, String> {
    let bytes = system.read(path, FileClass::Settings).map_err(|error| error.to_string())?;
    let text = String::from_utf8(bytes).map_err(|_| "it is not UTF-8".to_owned())?;
    val3_kinematics::Arm::from_toml(&text).map_err(|error| error.to_string())
}
