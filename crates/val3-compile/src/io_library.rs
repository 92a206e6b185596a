//! The library `io` of s5 and s6. The controller writes it, and its data are the signals and channels of the cell.

use val3_analysis::db::{Db, Project};
use val3_analysis::items::project::{folder, items, program_files};
use val3_analysis::ty::Base;
use val3_bytecode::LinkTarget;
use val3_lang::types::BaseType;

use crate::data::LoadedLink;

/// Whether a project is the library `io`, whose data need no link in their file.
pub(crate) fn is_io_library(db: &dyn Db, project: Project) -> bool {
    let is_named = folder(db, project).file_name().is_some_and(|name| name.eq_ignore_ascii_case("io"));
    is_named && items(db, project).version.major < 7 && program_files(db, project).is_empty()
}

/// Returns the link of data without a link in the file: the signal or channel with the same name. A signal that no file
/// in the cell declares is simulated.
pub(crate) fn link(db: &dyn Db, project: Project, name: &str, base: Base) -> Option<LoadedLink> {
    let Base::Builtin(base @ (BaseType::Dio | BaseType::Aio | BaseType::Sio), _) = base else { return None };
    let path = match base {
        BaseType::Sio if is_serial_line(db, project, name) => format!("Serial\\{name}"),
        BaseType::Sio => format!("Socket\\{name}"),
        _ => name.to_owned(),
    };
    Some(LoadedLink { path: Vec::new(), value: 0, link: 0, target: LinkTarget::Port(base, path) })
}

/// Whether the cell declares a serial line with this name.
fn is_serial_line(db: &dyn Db, project: Project, name: &str) -> bool {
    let devices = project.cell(db).map(|cell| &cell.config(db).io.devices);
    devices.and_then(|devices| devices.get("Serial")).is_some_and(|serial| serial.contains_key(name))
}
