//! Comparison of a project in both trees.

pub(super) mod initial_values;
mod programs;
mod sides;

use camino::{Utf8Path, Utf8PathBuf};
use val3_analysis::paths::path_key;

use super::renames::{self, Renamed};
use super::users::{self, Users};
use super::{contents, data, project, text};
use crate::applications::{Application, Matched, SourceFile};
use crate::exclusions::BlankComparison;
use crate::model::{ApplicationChange, Change, InterfaceChange, Problem};
use crate::read::project::ProjectVersion;
use programs::ProgramPair;
use sides::{DataSides, versions};

/// Program with which an application starts. A project without it is a library or a user type.
const START: &str = "start.pgx";

/// Compares a project; `None` if there is no difference. `trees` contains all applications of both trees.
pub(super) fn compare<'a, 't>(
    pair: &Matched<'a, 't>,
    trees: [&'a [Application<'t>]; 2],
    users: &Users,
    layout: BlankComparison,
    problems: &mut Vec<Problem>,
) -> Option<ApplicationChange> {
    let shown = pair.new.or(pair.old)?;
    let mut compared = ApplicationChange {
        name: shown.name.clone(),
        path: shown.path.to_string(),
        change: if is_loose(shown) { Change::Changed } else { Change::of(pair.old.is_some(), pair.new.is_some()) },
        moved_from: moved_from(pair),
        project: Vec::new(),
        libraries: Vec::new(),
        types: Vec::new(),
        programs: Vec::new(),
        data: Vec::new(),
        interface: Vec::new(),
        used_by: users::of(users, shown),
        texts: Vec::new(),
        contents: Vec::new(),
    };
    manifest(pair, &mut compared, problems);
    let mut data = read_data(pair, &mut compared, problems);
    let programs = programs::read(pair, &mut compared, problems);
    let renamed =
        renames::find([&data.old, &data.new], &programs.iter().map(ProgramPair::programs).collect::<Vec<_>>());
    let fields = initial_values::add(&mut data, pair, trees, &renamed.data);
    let mut interface = programs::compare(pair, programs, &renamed, layout, &mut compared);
    interface.extend(compare_data(pair, &data, &renamed, &mut compared, problems));
    if let (Some(old), Some(new)) = (pair.old, pair.new) {
        contents::add_data([&old.data_files(), &new.data_files()], fields, &mut compared);
        contents::add_project([old, new], &mut compared);
    }
    let is_library = !compared.used_by.is_empty() || !shown.programs.contains_key(START);
    if is_library && compared.change == Change::Changed && !is_loose(shown) {
        interface.sort_by(|a, b| (a.kind, &a.name).cmp(&(b.kind, &b.name)));
        compared.interface = interface;
    }
    (!compared.is_empty()).then_some(compared)
}

/// Whether the files belong to a folder without a project file. Such files are compared individually.
fn is_loose(application: &Application<'_>) -> bool {
    application.manifest.is_none()
}

/// Returns the old path if it differs. If one path ends with the other, the trees only have different roots.
fn moved_from(pair: &Matched<'_, '_>) -> Option<String> {
    let (old, new) = (pair.old?, pair.new?);
    let lower = |path: &Utf8Path| Utf8PathBuf::from(path_key(path.as_str()));
    let (old_path, new_path) = (lower(&old.path), lower(&new.path));
    let is_same = old_path.ends_with(&new_path) || new_path.ends_with(&old_path);
    (!is_same).then(|| old.path.to_string())
}

/// Compares the project files.
fn manifest(pair: &Matched<'_, '_>, compared: &mut ApplicationChange, problems: &mut Vec<Problem>) {
    fn read<'a>(side: Option<&'a Application<'_>>) -> Option<&'a ProjectVersion> {
        side.and_then(|application| application.project.as_ref())
    }
    fn version<'t>(side: Option<&Application<'t>>) -> Option<text::Version<'t>> {
        let bytes = side?.manifest?;
        Some(text::Version { bytes, is_readable: read(side).is_some() })
    }
    let sides = [version(pair.old), version(pair.new)];
    if sides.iter().flatten().any(|version| !version.is_readable) {
        compared.texts.extend(text::compare(&compared.path, sides, "a project file", problems));
        return;
    }
    let (old, new) = (read(pair.old), read(pair.new));
    let none = ProjectVersion::default();
    let (old, new) = (old.unwrap_or(&none), new.unwrap_or(&none));
    if compared.change == Change::Changed {
        compared.project = project::parameters(old, new);
    }
    compared.libraries = project::references(&old.libraries(), &new.libraries());
    compared.types = project::references(&old.types(), &new.types());
}

/// Reads the data of both versions; empty if the files are equal.
fn read_data(pair: &Matched<'_, '_>, compared: &mut ApplicationChange, problems: &mut Vec<Problem>) -> DataSides {
    let old_files = pair.old.map(Application::data_files).unwrap_or_default();
    let new_files = pair.new.map(Application::data_files).unwrap_or_default();
    unlisted_data(pair, compared, problems);
    if have_same_bytes(&old_files, &new_files) {
        return DataSides::default();
    }
    let (sides, broken) = DataSides::read(&old_files, &new_files);
    for (path, versions) in broken {
        compared.texts.extend(text::compare(&path, versions, "a data file", problems));
    }
    sides
}

fn have_same_bytes(old: &[(&str, &SourceFile<'_>)], new: &[(&str, &SourceFile<'_>)]) -> bool {
    old.iter().map(|(key, file)| (key, file.bytes)).eq(new.iter().map(|(key, file)| (key, file.bytes)))
}

fn compare_data(
    pair: &Matched<'_, '_>,
    sides: &DataSides,
    renamed: &Renamed,
    compared: &mut ApplicationChange,
    problems: &mut Vec<Problem>,
) -> Vec<InterfaceChange> {
    let units = [pair.old, pair.new].map(length_unit_mm);
    let found = data::compare([&sides.old, &sides.new], units, &renamed.data);
    for (side, message) in found.problems {
        problems.push(Problem { path: compared.path.clone(), side, message });
    }
    compared.data = found.data;
    found.interface
}

/// Returns the length unit in mm; 1 without a project file.
fn length_unit_mm(application: Option<&Application<'_>>) -> f64 {
    let project = application.and_then(|application| application.project.as_ref());
    project.map_or(1.0, |project| project.unit().millimetres())
}

/// Compares data files that neither project file lists as text, because the controller does not load them.
fn unlisted_data(pair: &Matched<'_, '_>, compared: &mut ApplicationChange, problems: &mut Vec<Problem>) {
    let files = [pair.old, pair.new].map(|side| side.map(|application| &application.data));
    for [old, new] in versions(files[0], files[1]) {
        if is_unlisted(pair.old, old) && is_unlisted(pair.new, new) {
            let path = new.or(old).map(|file| file.path.to_string()).unwrap_or_default();
            let sides = [old, new].map(|file| Some(text::Version { bytes: file?.bytes, is_readable: true }));
            compared.texts.extend(text::compare(&path, sides, "a data file", problems));
        }
    }
}

/// Whether the project file does not list the file. A missing application or file counts as unlisted.
fn is_unlisted(application: Option<&Application<'_>>, file: Option<&SourceFile<'_>>) -> bool {
    let has_list = application.is_none_or(|application| application.project.is_some());
    has_list && file.is_none_or(|file| !file.listed)
}
