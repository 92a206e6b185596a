//! Faults of a `cell.toml`, with the messages of a run.

use camino::Utf8Path;
use val3_analysis::arm::arm;
use val3_analysis::db::{Db, File, Project};
use val3_analysis::surroundings::path_type;
use val3_analysis::system::System;
use val3_cell::{ArmBase, Cell, CellError, CellFile, DataKind, Mesh, SignalClass, Surroundings};
use val3_config::{ConfigError, TableFile};
use val3_files::FileClass;
use val3_lang::suggest::nearest;
use val3_lang::types::BaseType;

use crate::completion::carrier_paths;
use crate::owner::surrounded;

/// A fault of a `cell.toml`.
pub type CellFault = ConfigError;

/// Faults of a `cell.toml` in its applications, each message once. A frame or tool that only some applications have is
/// no fault, unless `[run] cell` names the file.
pub fn cell_faults(db: &dyn Db, system: &dyn System, file: File) -> Vec<CellFault> {
    let table = match TableFile::<CellFile>::parse(file.path(db), file.text(db)) {
        Ok(table) => table,
        Err(error) => return vec![error],
    };
    let projects: Vec<Project> = surrounded(db, file).collect();
    let build = |project: Project, is_named: bool| build(db, system, &table, project, is_named);
    let built: Vec<Result<Cell, CellError>> =
        projects.iter().map(|project| build(*project, is_named(db, *project))).collect();
    let mut errors: Vec<CellError> = Vec::new();
    for error in built.iter().filter_map(|built| built.as_ref().err()) {
        if !errors.contains(error) {
            errors.push(error.clone());
        }
    }
    if errors.is_empty() && lacks_everywhere(&built) {
        errors.extend(projects.first().and_then(|project| build(*project, true).err()));
    }
    errors.into_iter().map(|error| table.fault(&error.key, error.message, error.help)).collect()
}

/// Whether every application lacks the carrier of a thing.
fn lacks_everywhere(built: &[Result<Cell, CellError>]) -> bool {
    let mut missing = built.iter().flatten().map(|cell| &cell.missing);
    let Some(first) = missing.next() else { return false };
    let rest: Vec<&Vec<String>> = missing.collect();
    first.iter().any(|name| rest.iter().all(|missing| missing.contains(name)))
}

fn is_named(db: &dyn Db, project: Project) -> bool {
    project.config(db).is_some_and(|config| config.run.cell.is_some())
}

fn build(
    db: &dyn Db,
    system: &dyn System,
    table: &TableFile<CellFile>,
    project: Project,
    is_named: bool,
) -> Result<Cell, CellError> {
    let base = arm(db, project)
        .as_ref()
        .map_or(ArmBase { axes: 6, height: 0.0 }, |arm| ArmBase { axes: arm.model.axes(), height: arm.model.height() });
    let mut application = LoadedApplication { db, system, project, folder: table.folder(), is_named };
    Cell::build(&table.content, base, &mut application)
}

/// An application of the workspace, and the folder of its `cell.toml`.
struct LoadedApplication<'a> {
    db: &'a dyn Db,
    system: &'a dyn System,
    project: Project,
    folder: &'a Utf8Path,
    is_named: bool,
}

impl LoadedApplication<'_> {
    fn paths(&self) -> Vec<String> {
        let of = |ty| carrier_paths(self.db, self.project, ty, false).into_iter().map(|(_, path)| path);
        of(BaseType::Frame).chain(of(BaseType::Tool)).collect()
    }
}

impl Surroundings for LoadedApplication<'_> {
    fn mesh(&mut self, path: &Utf8Path) -> Result<Mesh, String> {
        let is_below = path.is_relative() && !path.components().any(|part| part.as_str() == "..");
        let full = self.folder.join(path);
        if !is_below || !self.system.target(&full).starts_with(self.system.target(self.folder)) {
            return Err(format!("`{path}` is not in the folder of this file"));
        }
        let bytes = self.system.read(&full, FileClass::Shape);
        let bytes = bytes.map_err(|reason| format!("cannot read `{path}`: {reason}"))?;
        Mesh::read(&bytes).map_err(|error| format!("cannot use `{path}`: {error}"))
    }

    fn carrier(&self, name: &str) -> Result<DataKind, Option<String>> {
        match path_type(self.db, self.project, name) {
            Some(BaseType::Frame) => Ok(DataKind::Frame),
            Some(BaseType::Tool) => Ok(DataKind::Tool),
            _ => Err(nearest(name, self.paths().iter().map(String::as_str)).map(str::to_owned)),
        }
    }

    /// Signals are checked when the application runs: many of them exist only because data are linked to them.
    fn signal(&self, _: &str) -> Result<SignalClass, Option<String>> {
        Ok(SignalClass::Unknown)
    }

    fn may_lack_data(&self) -> bool {
        !self.is_named
    }
}

#[cfg(test)]
mod tests {
    use expect_test::{Expect, expect};
    use val3_analysis::db::Sources;

    use super::*;
    use crate::testing::MarkedListing;

    const APPLICATION: &str = "frame fPallet\ntool tGrip\nnum nA\nlibrary part \"Disk://part/part.pjx\"\ncls()\n\
        --- part\npublic frame fNest\n--- other\nframe fOther\nprogram start()\nbegin\n  cls()\nend\n\
        === /val3.toml\narm = \"tx2-60l\"\n";

    #[track_caller]
    fn check(cell: &str, expected: Expect) {
        let marked = MarkedListing::new(&format!("{APPLICATION}=== /cell.toml\n{cell}"));
        let db = marked.db();
        let file = *Sources::get(db).files(db).values().find(|file| file.path(db).ends_with("cell.toml")).unwrap();
        let shown = |fault: CellFault| format!("{}: {} ({})\n", &fault.text[fault.range], fault.message, fault.help);
        expected.assert_eq(&cell_faults(db, &marked.system, file).into_iter().map(shown).collect::<String>());
    }

    #[test]
    fn a_cell_without_faults_has_none() {
        let thing =
            |name: &str, carrier: &str| format!("[[object]]\nname = \"{name}\"\nin = \"{carrier}\"\nbox = [1, 2, 3]\n");
        let cell = ["world", "base", "link6", "fPallet", "tGrip", "part:fNest", "fOther", "a"].iter().zip('a'..);
        check(&cell.map(|(carrier, name)| thing(&name.to_string(), carrier)).collect::<String>(), expect![[""]]);
    }

    #[test]
    fn faults_are_those_of_a_run() {
        check(
            "clearence = 1",
            expect![[r#"
            clearence: there is no setting `clearence` (did you mean `clearance`?)
        "#]],
        );
        check(
            "[[object]]\nname = \"a\"\nin = \"link7\"\nbox = [1, 2, 3]",
            expect![[r#"
            in: the arm has no `link7` (its links are `link1` to `link6`)
        "#]],
        );
        check(
            "[[object]]\nname = \"a\"\nmesh = \"rack.stl\"",
            expect![[r#"
                mesh: cannot read `rack.stl`: it does not exist (name an existing STL or GLB file of at most 32 MB)
            "#]],
        );
        check(
            "[[object]]\nname = \"a\"\nmesh = \"../rack.stl\"",
            expect![[r#"
                mesh: `../rack.stl` is not in the folder of this file (name an existing STL or GLB file of at most 32 MB)
            "#]],
        );
        check(
            "[[object]]\nname = \"a\"\nbox = [1, 2",
            expect![[r#"
            : this is not TOML: unclosed array, expected `]` ()
        "#]],
        );
    }

    #[test]
    fn a_carrier_that_no_application_has_is_a_fault() {
        check(
            "[[object]]\nname = \"a\"\nin = \"fPalet\"\nbox = [1, 2, 3]",
            expect![[r#"
            in: there is no frame, tool or object `fPalet` (did you mean `fPallet`?)
        "#]],
        );
        check(
            "[[object]]\nname = \"a\"\nin = \"nA\"\nbox = [1, 2, 3]",
            expect![[r#"
            in: there is no frame, tool or object `nA` (write `world`, `base`, `flange`, `link1`, or a name of the application or of this file)
        "#]],
        );
    }
}
