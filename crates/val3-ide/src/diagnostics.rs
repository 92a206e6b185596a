//! Findings that are kept from one edit to the next: what a change does not concern is not checked again.

#![allow(missing_docs, reason = "the builders and setters that salsa generates cannot be documented")]

use val3_analysis::body::body;
use val3_analysis::db::{Db, File, Project};
use val3_analysis::effects::Effects;
use val3_analysis::flow::flow;
use val3_analysis::infer::infer;
use val3_analysis::items::project::program_files;
use val3_check::diagnostic::Diagnostic;
use val3_check::settings::WorkspaceSettings;
use val3_check::{
    Checked, Faults, Unit, check_alone, check_faults, check_member, finish, is_said_once, put_together, units,
};

/// What every application is checked for.
#[salsa::input(debug)]
pub struct CheckSettings {
    /// The settings by application.
    #[returns(ref)]
    pub settings: WorkspaceSettings,
}

/// What is wrong in a project: the findings of `val3 check`, in its order.
#[salsa::tracked]
pub fn project_diagnostics(db: &dyn Db, settings: CheckSettings, project: Project) -> Vec<Diagnostic> {
    let units = units(db, &[project]);
    let checked: Checked = units.iter().map(|unit| checked(db, settings, *unit).clone()).sum();
    finish(db, &units, settings.settings(db), checked).findings
}

/// What is wrong in one program of a project: the findings of [`project_diagnostics`] that lie in `file`, without a look
/// at the other programs beyond what the application does. `None` where `file` is no program of the project, or where
/// findings elsewhere decide which stand here.
pub fn program_diagnostics(
    db: &dyn Db,
    settings: CheckSettings,
    project: Project,
    file: File,
) -> Option<Vec<Diagnostic>> {
    let own = Unit::Program(project, file);
    if !units(db, &[project]).contains(&own) {
        return None;
    }
    // What the project finds may lie in programs: the libraries that they load. Nothing else lies in another file.
    let units = [Unit::Project(project), own];
    let checked: Checked = units.iter().map(|unit| checked(db, settings, *unit).clone()).sum();
    let mut found = finish(db, &units, settings.settings(db), checked).findings;
    found.retain(|finding| finding.place.file == file);
    (!found.iter().any(|finding| is_said_once(finding.rule))).then_some(found)
}

/// A part of what [`program_diagnostics`] asks for. Each finds what those before it have left.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Step {
    /// The code as plain data.
    Code,
    /// The ways through it. They need no types, so that they can be found beside those.
    Ways,
    /// The types.
    Types,
    /// What its lines do with variables.
    Uses,
    /// Its faults.
    Faults,
    /// What else shows when one looks at nothing but the program.
    Lints,
}

/// Finds a part of what is wrong in a program: another thread may do so beside the one that asks for it.
pub fn find_ahead(db: &dyn Db, settings: CheckSettings, (project, file): (Project, File), step: Step) {
    let unit = Unit::Program(project, file);
    match step {
        _ if !program_files(db, project).contains(&file) => {}
        Step::Code => _ = body(db, file),
        Step::Ways => _ = flow(db, file),
        Step::Types => _ = infer(db, project, file),
        Step::Uses => _ = Effects::new(db, project, file).all(),
        Step::Faults => _ = faults(db, settings, unit),
        Step::Lints => _ = alone(db, settings, unit),
    }
}

/// What only the application shows comes before what the program shows by itself, which another thread may be at.
#[salsa::tracked]
fn checked(db: &dyn Db, settings: CheckSettings, unit: Unit) -> Checked {
    let member = member(db, settings, unit).clone();
    put_together(db, faults(db, settings, unit).clone(), alone(db, settings, unit).clone(), member)
}

#[salsa::tracked]
fn faults(db: &dyn Db, settings: CheckSettings, unit: Unit) -> Faults {
    check_faults(db, unit, settings.settings(db))
}

/// Kept by itself: an edit that changes what the application does leaves it as it is in all programs but one.
#[salsa::tracked]
fn alone(db: &dyn Db, settings: CheckSettings, unit: Unit) -> Vec<Diagnostic> {
    check_alone(db, unit, settings.settings(db), faults(db, settings, unit))
}

#[salsa::tracked]
fn member(db: &dyn Db, settings: CheckSettings, unit: Unit) -> Vec<Diagnostic> {
    check_member(db, unit, settings.settings(db), faults(db, settings, unit))
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;
    use std::sync::{Arc, Mutex};

    use salsa::{Durability, Setter as _};
    use val3_analysis::db::{Database, Sources};
    use val3_analysis::load::{Workspace, load_into};
    use val3_analysis::system::{Disk, Memory};
    use val3_check::rules;
    use val3_check::settings::Selection;
    use val3_test::{Fixture, ROOT};

    use super::*;

    const CELL: &str = "num nA\nnA=1\ncall other()\nprogram other()\nbegin\n  nB=2\nend\n\
                        --- part\npublic num nWeight\nprogram pick()\nbegin\n  nWeight=nC\nend";

    const FINDINGS_FROM_ELSEWHERE: &str = "library part \"Disk://part/part.pjx\"\nnum nA\n\
        //val3: allow(V0302) silences nothing\nnA=part:libLoad(\"Disk://patr\")\ncall part:init()\n\
        call show(nA)\nprogram show(num x_nA)\nbegin\n  cls()\nend\n\
        --- part\npublic program init()\nbegin\n  putln(\"part\")\nend";

    #[test]
    fn an_edit_checks_again_what_it_concerns() {
        let ran = Arc::new(Mutex::new(Vec::new()));
        let log = Arc::clone(&ran);
        let db = Database::observed(move |event| {
            if let salsa::EventKind::WillExecute { database_key } = event.kind {
                log.lock().unwrap().push(format!("{database_key:?}"));
            }
        });
        let fixture = Fixture::parse(CELL);
        let files = fixture.files.into_iter().map(|(path, text)| (format!("{ROOT}/{path}"), text));
        let mut workspace = load_into(db, &Memory::new(files), &[ROOT.into()]).unwrap();
        let settings = WorkspaceSettings::new(&workspace.db, &workspace.projects, &Selection::default()).unwrap();
        let settings = CheckSettings::new(&workspace.db, settings);
        let codes = |db: &Database| -> Vec<Vec<&str>> {
            let found = workspace.projects.iter().map(|project| project_diagnostics(db, settings, *project));
            found.map(|found| found.iter().map(|found| found.rule.code).collect()).collect()
        };
        assert_eq!(codes(&workspace.db), [["V0101"], ["V0101"]]);
        let other = Sources::get(&workspace.db).files(&workspace.db).iter().find(|(path, _)| path.contains("other"));
        let (_, other) = other.unwrap();
        let (other, text) = (*other, other.text(&workspace.db).replace("nB=2", "\n  nB=2"));
        ran.lock().unwrap().clear();
        other.set_text(&mut workspace.db).to(text.into());
        assert_eq!(codes(&workspace.db), [["V0101"], ["V0101"]]);
        let ran = ran.lock().unwrap();
        assert_eq!(ran.iter().filter(|name| name.starts_with("checked(")).count(), 1, "{ran:?}");
        assert_eq!(ran.iter().filter(|name| name.starts_with("project_diagnostics(")).count(), 1);
    }

    #[test]
    fn lints_of_a_program_alone_do_not_ask_what_the_application_does() {
        let ran = Arc::new(Mutex::new(Vec::new()));
        let log = Arc::clone(&ran);
        let db = Database::observed(move |event| {
            if let salsa::EventKind::WillExecute { database_key } = event.kind {
                log.lock().unwrap().push(format!("{database_key:?}"));
            }
        });
        let examples = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples").into();
        let workspace = load_into(db, &Disk, &[examples]).unwrap();
        let db = &workspace.db;
        let codes: BTreeSet<&str> = rules::all().iter().map(|rule| rule.code).collect();
        let every = Selection { only: Some(codes.clone()), named: codes, ..Selection::default() };
        let settings = WorkspaceSettings::new(db, &workspace.projects, &every).unwrap();
        let settings = CheckSettings::new(db, settings);
        for unit in units(db, &workspace.projects) {
            alone(db, settings, unit);
            let asked = ran.lock().unwrap().iter().any(|name: &String| name.starts_with("application("));
            assert!(!asked, "a lint of {} is to be a `Member:` lint", unit.file(db).path(db));
        }
        workspace.projects.iter().for_each(|project| _ = project_diagnostics(db, settings, *project));
        assert!(ran.lock().unwrap().iter().any(|name| name.starts_with("application(")));
    }

    #[test]
    fn what_is_found_ahead_changes_nothing() {
        let examples =
            || load_into(Database::default(), &Disk, &[concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples").into()]);
        let (workspace, ahead) = (examples().unwrap(), examples().unwrap());
        let settings = |workspace: &Workspace| {
            let settings = WorkspaceSettings::new(&workspace.db, &workspace.projects, &Selection::default()).unwrap();
            CheckSettings::new(&workspace.db, settings)
        };
        let (settings_ahead, settings) = (settings(&ahead), settings(&workspace));
        for (project, other) in workspace.projects.iter().zip(&ahead.projects) {
            let programs = program_files(&workspace.db, *project).iter().zip(program_files(&ahead.db, *other));
            for (file, other_file) in programs {
                for step in [Step::Lints, Step::Uses, Step::Ways, Step::Faults, Step::Types, Step::Code] {
                    find_ahead(&ahead.db, settings_ahead, (*other, *other_file), step);
                }
                let found = program_diagnostics(&workspace.db, settings, *project, *file);
                let found_ahead = program_diagnostics(&ahead.db, settings_ahead, *other, *other_file);
                let codes = |found: Option<Vec<Diagnostic>>| {
                    found.map(|found| {
                        found.into_iter().map(|found| (found.rule.code, found.place.range)).collect::<Vec<_>>()
                    })
                };
                assert_eq!(codes(found_ahead), codes(found));
            }
        }
    }

    #[test]
    fn a_program_has_the_findings_of_the_whole_check() {
        let examples = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples").into();
        let fixture = Fixture::parse(FINDINGS_FROM_ELSEWHERE);
        let files = fixture.files.into_iter().map(|(path, text)| (format!("{ROOT}/{path}"), text));
        let written = load_into(Database::default(), &Memory::new(files), &[ROOT.into()]).unwrap();
        let mut judged = BTreeSet::new();
        for workspace in [load_into(Database::default(), &Disk, &[examples]).unwrap(), written] {
            let db = &workspace.db;
            let codes: BTreeSet<&str> = rules::all().iter().map(|rule| rule.code).collect();
            let every = Selection { only: Some(codes.clone()), named: codes, ..Selection::default() };
            let settings = CheckSettings::new(db, WorkspaceSettings::new(db, &workspace.projects, &every).unwrap());
            for project in workspace.projects {
                let whole = project_diagnostics(db, settings, project);
                for file in program_files(db, project) {
                    let expected: Vec<_> = whole.iter().filter(|found| found.place.file == *file).cloned().collect();
                    match program_diagnostics(db, settings, project, *file) {
                        Some(found) => assert_eq!(sorted(found), sorted(expected.clone())),
                        None => assert!(whole.iter().any(|found| is_said_once(found.rule))),
                    }
                    judged.extend(expected.iter().map(|found| found.rule.code));
                }
            }
        }
        // A library that cannot be found is a finding of the project, a comment that silences nothing one of the whole.
        assert!(["V0604", "V0702", "V0114"].iter().all(|code| judged.contains(code)), "{judged:?}");
    }

    fn sorted(mut found: Vec<Diagnostic>) -> Vec<Diagnostic> {
        found.sort_by_key(|found| (found.place.range.start(), found.rule.code, found.message.clone()));
        found
    }

    #[test]
    fn an_edit_looks_at_nothing_of_projects_that_it_does_not_reach() {
        let looked = Arc::new(Mutex::new(Vec::new()));
        let log = Arc::clone(&looked);
        let db = Database::observed(move |event| {
            if let salsa::EventKind::DidValidateMemoizedValue { database_key } = event.kind {
                log.lock().unwrap().push(format!("{database_key:?}"));
            }
        });
        let fixture = Fixture::parse(CELL);
        let files = fixture.files.into_iter().map(|(path, text)| (format!("{ROOT}/{path}"), text));
        let mut workspace = load_into(db, &Memory::new(files), &[ROOT.into()]).unwrap();
        let settings = WorkspaceSettings::new(&workspace.db, &workspace.projects, &Selection::default()).unwrap();
        let settings = CheckSettings::builder(settings).durability(Durability::MEDIUM).new(&workspace.db);
        let other = Sources::get(&workspace.db).files(&workspace.db).iter().find(|(path, _)| path.contains("other"));
        let (_, other) = other.unwrap();
        let other = *other;
        for number in 0..3 {
            let text = other.text(&workspace.db).replace("nB=", &format!("nB={number}"));
            other.set_text(&mut workspace.db).with_durability(Durability::LOW).to(text.into());
            looked.lock().unwrap().clear();
            workspace.projects.iter().for_each(|project| _ = project_diagnostics(&workspace.db, settings, *project));
        }
        // Of the three programs, the one that was not edited and belongs to the edited project.
        let looked = looked.lock().unwrap();
        assert_eq!(looked.iter().filter(|name| name.starts_with("infer(")).count(), 1, "{looked:?}");
    }
}
