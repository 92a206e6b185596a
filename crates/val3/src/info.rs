//! `val3 info`: describes the controllers in a backup.

mod devices;
mod document;
mod human;
mod missing;

use std::process::ExitCode;

use camino::Utf8Path;
use val3_backup::info::{ControllerInfo, ControllerRoot, controller_info, controller_roots};
use val3_backup::log::log_folders;
use val3_controller::LOG_FOLDER;

use self::devices::{DeviceInfo, devices};
use crate::args::{InfoArgs, InfoFormat};
use crate::backup_files::{OpenedBackup, RemoteFolders, open, open_address};
use crate::color::Color;
use crate::controller::check_no_option;
use crate::output::{OutputContent, to_stdout_as};
use crate::paths::{Paths, current_folder, is_address};
use crate::user_error::{EXIT_USAGE, UserError};

/// Folders of a controller at an address that are read.
const FOLDERS: RemoteFolders = RemoteFolders {
    downloaded: &["usr/usrapp", "usr/configs", "usr/app", "usr/applicom"],
    listed: &["sys/configs", LOG_FOLDER],
};

/// Description of one controller.
struct DescribedController {
    /// Displayed path.
    path: String,
    info: ControllerInfo,
    devices: Vec<DeviceInfo>,
    /// Paths of folders with logs, from the current folder.
    logs: Vec<String>,
    /// What `val3 run` needs and the backup does not contain, a sentence each.
    missing: Vec<String>,
    /// Files and folders that were not read, with the reason.
    unread: Vec<(String, String)>,
}

/// Runs the command. The exit code states whether every file was read.
pub(crate) fn run(args: &InfoArgs, color: Color) -> Result<ExitCode, UserError> {
    let current = current_folder()?;
    let paths = Paths::new(&[], &current);
    let backup = match is_address(&args.path) {
        true => open_address(&args.path, &args.connection, &FOLDERS)?,
        false => {
            check_no_option(&args.connection)?;
            open(&current.join(&args.path))?
        }
    };
    let roots = controller_roots(backup.files.files());
    let described: Vec<DescribedController> = roots.iter().map(|root| describe(&backup, root, &paths)).collect();
    if described.iter().all(is_unknown) {
        let message = format!("`{}` contains neither applications nor settings of a controller", args.path);
        return Err(UserError::new(message).with_help("name the folder or the zip of a backup, or a cell"));
    }
    match args.format {
        InfoFormat::Human => to_stdout_as(OutputContent::Words, color, |out| human::write(&described, out))?,
        InfoFormat::Json => {
            let document = document::document(&described);
            to_stdout_as(OutputContent::Json, color, |out| writeln!(out, "{document}"))?;
        }
    }
    let is_read = described.iter().all(|controller| controller.unread.is_empty());
    Ok(if is_read { ExitCode::SUCCESS } else { ExitCode::from(EXIT_USAGE) })
}

fn describe(backup: &OpenedBackup, root: &ControllerRoot, paths: &Paths) -> DescribedController {
    let place = match root.path.as_str() {
        "" => backup.root.clone(),
        path => backup.root.join(path),
    };
    let info = controller_info(backup.files.as_ref(), root);
    let (devices, unread_devices) = devices(backup.files.as_ref(), &root.usr);
    let logs = log_folders(backup.files.files()).into_iter();
    let logs = logs.filter(|folder| Utf8Path::new(&folder.path).starts_with(&root.path));
    let of_backup = |path: &str| paths.to_open(&backup.root.join(path));
    let found = backup.unread.iter().chain(&backup.denied);
    let mut unread: Vec<(String, String)> = found.map(|(path, reason)| (paths.to_open(path), reason.clone())).collect();
    let files = info.unread.iter().chain(&unread_devices).map(|file| (of_backup(&file.path), file.reason.clone()));
    for (path, reason) in files {
        if !unread.iter().any(|(known, _)| *known == path) {
            unread.push((path, reason));
        }
    }
    DescribedController {
        path: paths.to_open(&place),
        logs: logs.map(|folder| of_backup(&folder.path)).collect(),
        missing: missing::missing(backup, &place, &info),
        info,
        devices,
        unread,
    }
}

/// Whether nothing of a controller was found.
fn is_unknown(controller: &DescribedController) -> bool {
    let ControllerInfo { serial, version, arm, users, applications, .. } = &controller.info;
    let is_empty = serial.is_none() && version.is_none() && arm.is_none() && users.is_empty();
    is_empty && applications.is_empty() && controller.devices.is_empty() && controller.unread.is_empty()
}
