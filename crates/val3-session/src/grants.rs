//! The folders, lines and machines outside of the cell that a run was given, and settings that may not give them.

use camino::{Utf8Path, Utf8PathBuf};
use val3_analysis::db::{Database, Project};
use val3_analysis::items::project::folder;
use val3_analysis::load::cell_around;
use val3_analysis::paths::inside;
use val3_analysis::system::Disk;
use val3_config::{ConfigError, ConfigFile, trust};

use crate::connection::Connection;
use crate::error::SessionError;
use crate::settings::{ControllerSettings, MergedSettings};

/// Whether the user trusts a settings file.
pub(crate) fn is_trusted(file: &ConfigFile) -> bool {
    trust::is_trusted(&real(file.folder()))
}

/// Checks that `[run]` of a settings file gives access to this machine only. The arguments of the command and the user's
/// trust allow more.
///
/// # Errors
/// The first setting that reaches a device or another machine.
pub(crate) fn check(file: &ConfigFile, lines: &[Connection], settings: &ControllerSettings) -> Result<(), ConfigError> {
    let outside = |key: &str, reach: &str, option: &str| {
        let mut error = file.outside(key, reach, file.folder());
        error.help.push_str(&format!("; for one command: {option}"));
        error
    };
    if file.config.run.network && !settings.network {
        return Err(outside("run.network", "lets sockets reach other machines", "--network"));
    }
    for line in lines {
        let key = format!("run.lines.{}", line.link());
        let option = || format!("--line '{line}'");
        if settings.connections.iter().any(|given| given.is_for(line.link())) {
            continue;
        }
        if let Some(device) = line.device() {
            return Err(outside(&key, &format!("opens the device `{device}`"), &option()));
        }
        if let Some(address) = line.target().filter(|address| !address.is_loopback() && !settings.network) {
            return Err(outside(&key, &format!("connects to another machine, {address}"), &option()));
        }
    }
    Ok(())
}

/// The path after following links, or as it is where it does not exist.
pub(crate) fn real(path: &Utf8Path) -> Utf8PathBuf {
    path.canonicalize_utf8().unwrap_or_else(|_| path.to_owned())
}

/// Sentences on the folders outside of the cell, the lines and the network that the controller of a project is given.
///
/// # Errors
/// A setting is at fault.
pub(crate) fn notes(
    db: &Database,
    project: Project,
    settings: &ControllerSettings,
) -> Result<Vec<String>, SessionError> {
    let file = project.configuration(db).map(|configuration| configuration.file(db));
    let merged = MergedSettings::of(settings, file)?;
    let application = folder(db, project);
    let mut cells = vec![cell_around(&Disk, application)];
    cells.extend(file.map(|file| cell_around(&Disk, file.folder())));
    let disk = project.disk(db).or(application.parent()).unwrap_or(application);
    if disk.file_name().is_some_and(|name| name.eq_ignore_ascii_case("usrapp")) {
        // The applications of a controller, with the folders next to them.
        let around = disk.parent().unwrap_or(disk);
        let is_usr = around.file_name().is_some_and(|name| name.eq_ignore_ascii_case("usr"));
        cells.push(real(around.parent().filter(|_| is_usr).unwrap_or(around)));
    }
    let is_outside = |folder: &Utf8Path| !cells.iter().any(|cell| real(folder).starts_with(cell));
    let roots = merged.roots.iter().map(|root| (root.name.as_str(), root.folder.as_path()));
    // As for the media: the folder around an application that is not on the disk is a root of its own.
    let around =
        application.parent().filter(|_| inside(application, disk).is_none()).map(|folder| ("Outside0", folder));
    let roots = [("Disk", disk)].into_iter().chain(around).chain(roots).filter(|(_, folder)| is_outside(folder));
    let roots = roots.map(|(name, folder)| format!("`{name}://` is the folder `{folder}`, outside of the cell"));
    let lines = merged.named.iter().map(|line| format!("a line has a connection: {line}"));
    let network = merged.network.then(|| "sockets reach other machines".to_owned());
    Ok(roots.chain(lines).chain(network).collect())
}
