//! Files of a cell that describe its controller: inputs and outputs, arm and language.

use std::fs;

use camino::Utf8Path;
use val3_analysis::db::{Database, Project};
use val3_machine::devices::Devices;
use val3_syntax::encoding::decode;

use crate::arm::ChosenArm;

/// Declares the inputs and outputs that the configuration of the cell names.
pub(crate) fn declare_io(devices: &mut Devices, db: &Database, project: Project) {
    let Some(cell) = project.cell(db) else { return };
    for (device, signals) in &cell.config(db).io {
        let mut signals: Vec<_> = signals.iter().map(|(name, base)| (name.as_str(), *base)).collect();
        signals.sort_unstable_by_key(|(name, _)| *name);
        devices.state.io.declare_device(device, signals);
    }
}

/// Gives the controller the arm and the language of the cell around `disk`; the arm is `chosen` where that is one.
pub(crate) fn describe(devices: &mut Devices, disk: &Utf8Path, chosen: Option<ChosenArm>) {
    if let Some(ChosenArm { model, name }) = chosen {
        devices.state.set_arm(model, &name);
    }
    for name in ["arm.cfx", "cell.cfx"] {
        if let Some(text) = config(disk, name) {
            devices.describe(&text);
        }
    }
}

/// The text of a file in `usr/configs` of the cell around `disk`, if there is one.
pub(crate) fn config(disk: &Utf8Path, name: &str) -> Option<String> {
    let bytes = fs::read(disk.parent()?.join("configs").join(name)).ok()?;
    Some(decode(bytes).text)
}
