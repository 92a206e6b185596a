//! Scenarios of a served run (`val3 run --serve`), written while the run continues.

use camino::{Utf8Path, Utf8PathBuf};
use val3_analysis::load::{cell_around, nearest_configuration};
use val3_analysis::paths::normalise;
use val3_analysis::system::Disk;
use val3_lang::test_names::TESTS;
use val3_machine::event::Event;
use val3_view::wire::Recorded;

use super::run_record::RunRecord;
use super::{NewScenario, check_new, manifest, refused};
use crate::args::ControllerArgs;
use crate::in_memory::archive_around;
use crate::paths::{Paths, current_folder};
use crate::user_error::UserError;

/// Longest name of a scenario, in characters.
const LONGEST: usize = 64;

/// Served run up to now.
pub(crate) struct ServedRun {
    /// Absolute path of the application.
    pub(crate) application: Utf8PathBuf,
    pub(crate) controller: ControllerArgs,
    pub(crate) events: Vec<Event>,
    /// Seconds since the controller was started.
    pub(crate) now: f64,
}

/// Writes the scenario `name` of a served run. Returns the response.
///
/// # Errors
/// The name is not a file name or is taken, or a scenario cannot repeat the run.
pub(crate) fn record_served(run: &ServedRun, name: &str) -> Result<Recorded, UserError> {
    check_name(name)?;
    if let Some(archive) = archive_around(&run.application) {
        return Err(UserError::new(format!("the application is in the archive `{archive}`"))
            .with_help("unpack it, and run the application from there"));
    }
    let manifest = manifest(&run.application)?;
    let current = current_folder()?;
    let path = tests_folder(&manifest)?.join(name).with_extension("toml");
    let shown = Paths::new(&[], &current).shown(&path).to_string();
    let shown = Utf8Path::new(&shown);
    check_new(&path, shown)?;
    let lines: Result<Vec<String>, _> = run.events.iter().map(serde_json::to_string).collect();
    let lines = lines.map_err(|error| refused(shown, &error.to_string()))?.join("\n");
    let mut record = RunRecord::read(&lines).map_err(|reason| refused(shown, &reason))?;
    record.continue_at(run.now);
    let heading = "Recorded from a served run".to_owned();
    let controller = run.controller.clone();
    let new = NewScenario { run: &record, heading, manifest: &manifest, path: &path, shown, controller };
    let written = new.write()?;
    Ok(Recorded { file: shown.to_string(), text: written.text, remarks: written.remarks })
}

/// Checks that a name is a file name on each system.
fn check_name(name: &str) -> Result<(), UserError> {
    if !name.is_empty() && name.len() <= LONGEST && name.chars().all(is_part_of_name) {
        return Ok(());
    }
    Err(UserError::new(format!("`{name}` is not the name of a scenario"))
        .with_help(format!("write 1 to {LONGEST} letters, digits, `_` and `-`")))
}

fn is_part_of_name(character: char) -> bool {
    character.is_ascii_alphanumeric() || matches!(character, '_' | '-')
}

/// Folder for an application's scenarios: the nearest folder `tests` next to the application or above it in the cell,
/// otherwise a new folder next to the nearest `val3.toml`, otherwise next to `usr`, otherwise next to the application.
fn tests_folder(manifest: &Utf8Path) -> Result<Utf8PathBuf, UserError> {
    let application = manifest.parent().unwrap_or(manifest);
    let above = application.parent().unwrap_or(application);
    let configuration = nearest_configuration(&Disk, application).map_err(|error| UserError::new(error.to_string()))?;
    let configured = configuration.as_ref().map(|file| file.folder().to_owned());
    let cell = cell_around(&Disk, configured.as_deref().unwrap_or(above));
    let existing = application
        .ancestors()
        .skip(1)
        .take_while(|folder| folder.starts_with(&cell))
        .map(|folder| folder.join(TESTS))
        .find(|tests| tests.is_dir());
    let usr = application.ancestors().find(|folder| folder.file_name() == Some("usr"));
    let beside_usr = usr.and_then(Utf8Path::parent).map(Utf8Path::to_owned);
    let new = || configured.or(beside_usr).unwrap_or_else(|| above.to_owned()).join(TESTS);
    Ok(normalise(&existing.unwrap_or_else(new)))
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;

    #[test]
    fn names_are_file_names() {
        for name in ["twoBoxes", "two_boxes-2", &"a".repeat(LONGEST)] {
            assert_eq!(check_name(name), Ok(()), "{name}");
        }
        for name in ["", "../x", "a/b", "a.b", "a b", "ä", &"a".repeat(LONGEST + 1)] {
            assert!(check_name(name).is_err(), "{name}");
        }
    }

    #[test]
    fn the_folder_is_the_nearest_one_in_the_cell() {
        let root = tempfile::tempdir().unwrap();
        let root = Utf8Path::from_path(root.path()).unwrap().canonicalize_utf8().unwrap();
        let application = root.join("cell/usr/usrapp/main");
        fs::create_dir_all(&application).unwrap();
        let folder = || tests_folder(&application.join("main.pjx")).unwrap();
        // A folder above the cell is not used.
        fs::create_dir(root.join("tests")).unwrap();
        assert_eq!(folder(), root.join("cell/tests"));
        fs::write(root.join("cell/usr/val3.toml"), "").unwrap();
        assert_eq!(folder(), root.join("cell/usr/tests"));
        fs::create_dir(root.join("cell/usr/usrapp/tests")).unwrap();
        assert_eq!(folder(), root.join("cell/usr/usrapp/tests"));
    }
}
