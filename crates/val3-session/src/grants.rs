//! Access of a run to folders, lines and machines outside the cell, and checks of settings that request it.

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

/// Checks that `[run]` of a settings file only allows access to this machine. Command line arguments and the user's
/// trust allow more.
///
/// # Errors
/// The first setting that allows access to a device or another machine.
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

/// Path with resolved links; the path itself if it does not exist.
pub(crate) fn real(path: &Utf8Path) -> Utf8PathBuf {
    path.canonicalize_utf8().unwrap_or_else(|_| path.to_owned())
}

/// Sentences about the folders outside the cell, the lines and the network to which a project's controller has access.
///
/// # Errors
/// If a setting is invalid.
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
        // The applications of a controller, with their neighbouring folders.
        let around = disk.parent().unwrap_or(disk);
        let is_usr = around.file_name().is_some_and(|name| name.eq_ignore_ascii_case("usr"));
        cells.push(real(around.parent().filter(|_| is_usr).unwrap_or(around)));
    }
    let is_outside = |folder: &Utf8Path| !cells.iter().any(|cell| real(folder).starts_with(cell));
    let roots = merged.roots.iter().map(|root| (root.name.as_str(), root.folder.as_path()));
    // As in `Media`, the folder around an application outside the disk is a separate root.
    let around =
        application.parent().filter(|_| inside(application, disk).is_none()).map(|folder| ("Outside0", folder));
    let roots = [("Disk", disk)].into_iter().chain(around).chain(roots).filter(|(_, folder)| is_outside(folder));
    let roots = roots.map(|(name, folder)| format!("`{name}://` is the folder `{folder}`, outside of the cell"));
    let lines = merged.named.iter().map(|line| format!("a line has a connection: {line}"));
    let network = merged.network.then(|| "sockets reach other machines".to_owned());
    Ok(roots.chain(lines).chain(network).collect())
}
