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
    if file.config.run.network && !settings.network {
        return Err(outside(file, "run.network", "lets sockets reach other machines", "--network"));
    }
    for line in lines {
        if settings.connections.iter().any(|given| given.is_for(line.link())) {
            continue;
        }
        let reach = if let Some(device) = line.device() {
            format!("opens the device `{device}`")
        } else if let Some(address) = line.target().filter(|address| !address.is_loopback() && !settings.network) {
            format!("connects to another machine, {address}")
        } else {
            continue;
        };
        return Err(outside(file, &format!("run.lines.{}", line.link()), &reach, &format!("--line '{line}'")));
    }
    Ok(())
}

/// Error for a setting that allows more than this machine. `option` is the command line argument that allows the same.
fn outside(file: &ConfigFile, key: &str, reach: &str, option: &str) -> ConfigError {
    let mut error = file.outside(key, reach, file.folder());
    error.help.push_str(&format!("; for one command: {option}"));
    error
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
    let roots = merged.roots.iter().map(|root| (root.name.as_str(), root.folder.as_path()));
    // As in `Media`, the folder around an application outside the disk is a separate root.
    let around =
        application.parent().filter(|_| inside(application, disk).is_none()).map(|folder| ("Outside0", folder));
    let roots = [("Disk", disk)].into_iter().chain(around).chain(roots);
    let roots = roots.filter(|(_, folder)| !cells.iter().any(|cell| real(folder).starts_with(cell)));
    let roots = roots.map(|(name, folder)| format!("`{name}://` is the folder `{folder}`, outside of the cell"));
    let lines = merged.named.iter().map(|line| format!("a line has a connection: {line}"));
    let network = merged.network.then(|| "sockets reach other machines".to_owned());
    Ok(roots.chain(lines).chain(network).collect())
}
