//! Memoised findings: parts that an edit does not affect are not checked again.

#![allow(missing_docs, reason = "the builders and setters that salsa generates cannot be documented")]

use val3_analysis::db::{Db, File, Project};
use val3_check::diagnostic::Diagnostic;
use val3_check::settings::WorkspaceSettings;
use val3_check::{
    CheckUnit, Checked, UnitFaults, check_faults, check_in_application, check_local, finish_each, has_shared_cause,
    is_once_per_application, join_causes, merge_findings, units,
};

/// Check settings of all applications.
#[salsa::input(debug)]
pub struct CheckSettings {
    /// Settings by application.
    #[returns(ref)]
    pub settings: WorkspaceSettings,
}

/// Findings of a project, in the order of `val3 check`. If several of `projects` share a cause, the finding is reported
/// only in the first of them, as `val3 check` does for all projects.
pub fn project_diagnostics(
    db: &dyn Db,
    settings: CheckSettings,
    projects: &[Project],
    project: Project,
) -> Vec<Diagnostic> {
    let own = own_diagnostics(db, settings, project);
    if !own.iter().any(|finding| has_shared_cause(db, finding)) {
        return own.clone();
    }
    let all = projects.iter().flat_map(|project| own_diagnostics(db, settings, *project));
    let shared = all.filter(|finding| has_shared_cause(db, finding));
    let manifest = project.manifest(db);
    let mut first = join_causes(db, shared.cloned().collect());
    first.retain(|finding| finding.application == Some(manifest));
    let mut first = first.into_iter().peekable();
    // The remaining findings keep the order of the project.
    let mut found = Vec::with_capacity(own.len());
    for finding in own {
        if !has_shared_cause(db, finding) {
            found.push(finding.clone());
        } else if first.peek().is_some_and(|first| first.place == finding.place && first.message == finding.message) {
            found.extend(first.next());
        }
    }
    found
}

/// Computes and memoises the findings of a project, for [`project_diagnostics`].
pub fn check_project(db: &dyn Db, settings: CheckSettings, project: Project) {
    own_diagnostics(db, settings, project);
}

/// Findings of a project, independent of other projects.
#[salsa::tracked]
fn own_diagnostics(db: &dyn Db, settings: CheckSettings, project: Project) -> Vec<Diagnostic> {
    let units = units(db, &[project]);
    let checked: Checked = units.iter().map(|unit| checked(db, settings, *unit).clone()).sum();
    finish_each(db, &units, settings.settings(db), checked).findings
}

/// Findings of [`project_diagnostics`] in one program, computed without checking other programs. `None` if `file` is no
/// program of the project, or if findings elsewhere determine which findings are reported here.
pub fn program_diagnostics(
    db: &dyn Db,
    settings: CheckSettings,
    project: Project,
    file: File,
) -> Option<Vec<Diagnostic>> {
    let own = CheckUnit::Program(project, file);
    if !units(db, &[project]).contains(&own) {
        return None;
    }
    // Findings of the project may be in programs, for example at the libraries that they load. Other units only have
    // findings in their own file.
    let units = [CheckUnit::Project(project), own];
    let checked: Checked = units.iter().map(|unit| checked(db, settings, *unit).clone()).sum();
    let mut found = finish_each(db, &units, settings.settings(db), checked).findings;
    found.retain(|finding| finding.place.file == file);
    match found.iter().any(|finding| is_once_per_application(finding.rule) || has_shared_cause(db, finding)) {
        true => None,
        false => Some(found),
    }
}

/// Findings in a unit.
#[salsa::tracked]
fn checked(db: &dyn Db, settings: CheckSettings, unit: CheckUnit) -> Checked {
    let member = member(db, settings, unit).clone();
    merge_findings(db, faults(db, settings, unit).clone(), alone(db, settings, unit).clone(), member)
}

#[salsa::tracked]
fn faults(db: &dyn Db, settings: CheckSettings, unit: CheckUnit) -> UnitFaults {
    check_faults(db, unit, settings.settings(db))
}

/// A separate query, because most edits change the local findings of only one program.
#[salsa::tracked]
fn alone(db: &dyn Db, settings: CheckSettings, unit: CheckUnit) -> Vec<Diagnostic> {
    check_local(db, unit, settings.settings(db), faults(db, settings, unit))
}

#[salsa::tracked]
fn member(db: &dyn Db, settings: CheckSettings, unit: CheckUnit) -> Vec<Diagnostic> {
    check_in_application(db, unit, settings.settings(db), faults(db, settings, unit))
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;
    use std::sync::{Arc, Mutex};

    use salsa::{Durability, Setter as _};
    use val3_analysis::db::{Database, Sources};
    use val3_analysis::items::project::program_files;
    use val3_analysis::load::load_into;
    use val3_analysis::system::{Disk, Memory};
    use val3_check::rules;
    use val3_check::settings::RuleSelection;
    use val3_test::{Fixture, ROOT};

    use super::*;

    const CELL: &str = "num nA\nnA=1\ncall other()\nprogram other()\nbegin\n  nB=2\nend\n\
                        --- part\npublic num nWeight\nprogram pick()\nbegin\n  nWeight=nC\nend";

    const FINDINGS_FROM_ELSEWHERE: &str = "library part \"Disk://part/part.pjx\"\nnum nA\n\
        //val3: allow(V0302) silences nothing\nnA=part:libLoad(\"Disk://patr\")\ncall part:init()\n\
        call show(nA)\nprogram show(num x_nA)\nbegin\n  cls()\nend\n\
        --- part\npublic program init()\nbegin\n  putln(\"part\")\nend";

    #[test]
    fn an_edit_checks_the_affected_programs_again() {
        let ran = Arc::new(Mutex::new(Vec::new()));
        let log = Arc::clone(&ran);
        let db = Database::observed(move |event| {
            if let salsa::EventKind::WillExecute { database_key } = event.kind {
                log.lock().unwrap().push(format!("{database_key:?}"));
            }
        });
        let fixture = Fixture::parse(CELL).with_stops();
        let files = fixture.files.into_iter().map(|(path, text)| (format!("{ROOT}/{path}"), text));
        let mut workspace = load_into(db, &Memory::new(files), &[ROOT.into()]).unwrap();
        let settings = WorkspaceSettings::new(&workspace.db, &workspace.projects, &RuleSelection::default()).unwrap();
        let settings = CheckSettings::new(&workspace.db, settings);
        let projects = &workspace.projects;
        assert_eq!(own_codes(&workspace.db, settings, projects), [["V0101"], ["V0101"]]);
        let other = file(&workspace.db, "other.pgx");
        let text = other.text(&workspace.db).replace("nB=2", "\n  nB=2");
        ran.lock().unwrap().clear();
        other.set_text(&mut workspace.db).to(text.into());
        assert_eq!(own_codes(&workspace.db, settings, projects), [["V0101"], ["V0101"]]);
        let ran = ran.lock().unwrap();
        assert_eq!(ran.iter().filter(|name| name.starts_with("checked(")).count(), 1, "{ran:?}");
        assert_eq!(ran.iter().filter(|name| name.starts_with("own_diagnostics(")).count(), 1);
    }

    /// Codes of each project's own findings.
    fn own_codes<'db>(db: &'db Database, settings: CheckSettings, projects: &[Project]) -> Vec<Vec<&'db str>> {
        let found = projects.iter().map(|project| own_diagnostics(db, settings, *project));
        found.map(|found| found.iter().map(|found| found.rule.code).collect()).collect()
    }

    fn file(db: &Database, name: &str) -> File {
        *Sources::get(db).files(db).iter().find(|(path, _)| path.ends_with(name)).unwrap().1
    }

    const REACH: &str = "movej(pA,flange,mA)\n\nprogram other()\nbegin\nputln(1)\nend\n\n\
        === main/main.dtx\n<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<Database \
        xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" \
        xmlns=\"http://www.staubli.com/robotics/VAL3/Data/2\">\n<Datas>\n\
        <Data name=\"mA\" access=\"private\" xsi:type=\"array\" type=\"mdesc\" size=\"1\"/>\n\
        <Data name=\"pA\" access=\"private\" xsi:type=\"array\" type=\"pointRx\" size=\"1\">\n\
        <Value key=\"0\" x=\"2000\" z=\"300\" rx=\"180\" fatherId=\"world[0]\"/></Data>\n</Datas>\n</Database>\n\
        === /usrapp/val3.toml\n[lint]\nmotion = true\n";

    #[test]
    fn the_reach_of_points_is_not_computed_again_for_an_edit_in_a_program() {
        let ran = Arc::new(Mutex::new(Vec::new()));
        let log = Arc::clone(&ran);
        let db = Database::observed(move |event| {
            if let salsa::EventKind::WillExecute { database_key } = event.kind {
                log.lock().unwrap().push(format!("{database_key:?}"));
            }
        });
        let files = Fixture::parse(REACH).files.into_iter().map(|(path, text)| (format!("{ROOT}/{path}"), text));
        let mut workspace = load_into(db, &Memory::new(files), &[ROOT.into()]).unwrap();
        let settings = WorkspaceSettings::new(&workspace.db, &workspace.projects, &RuleSelection::default()).unwrap();
        let settings = CheckSettings::new(&workspace.db, settings);
        let project = workspace.projects[0];
        let codes = |db: &Database| own_codes(db, settings, &[project]).concat().join(" ");
        let unreachable = |db: &Database| codes(db).matches("V0411").count();
        assert_eq!(unreachable(&workspace.db), 1);
        let other = file(&workspace.db, "other.pgx");
        let text = other.text(&workspace.db).replace("putln(1)", "putln(2)\nputln(3)");
        ran.lock().unwrap().clear();
        other.set_text(&mut workspace.db).to(text.into());
        assert_eq!(unreachable(&workspace.db), 1);
        // Only the edited program is checked again.
        assert_eq!(ran.lock().unwrap().iter().filter(|name| name.starts_with("member(")).count(), 1, "{ran:?}");
        let data = file(&workspace.db, "main.dtx");
        let text = data.text(&workspace.db).replace("2000", "500");
        data.set_text(&mut workspace.db).to(text.into());
        assert_eq!(unreachable(&workspace.db), 0);
    }

    #[test]
    fn lints_of_a_program_do_not_depend_on_the_application() {
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
        let every = RuleSelection { only: Some(codes.clone()), named: codes, ..RuleSelection::default() };
        let settings = WorkspaceSettings::new(db, &workspace.projects, &every).unwrap();
        let settings = CheckSettings::new(db, settings);
        for unit in units(db, &workspace.projects) {
            alone(db, settings, unit);
            let asked = ran.lock().unwrap().iter().any(|name: &String| name.starts_with("application("));
            assert!(!asked, "a lint of {} is to be a `Member:` lint", unit.file(db).path(db));
        }
        workspace.projects.iter().for_each(|project| _ = own_diagnostics(db, settings, *project));
        assert!(ran.lock().unwrap().iter().any(|name| name.starts_with("application(")));
    }

    #[test]
    fn a_program_has_the_same_findings_as_in_a_whole_check() {
        let examples = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples").into();
        let fixture = Fixture::parse(FINDINGS_FROM_ELSEWHERE);
        let files = fixture.files.into_iter().map(|(path, text)| (format!("{ROOT}/{path}"), text));
        let written = load_into(Database::default(), &Memory::new(files), &[ROOT.into()]).unwrap();
        let mut judged = BTreeSet::new();
        for workspace in [load_into(Database::default(), &Disk, &[examples]).unwrap(), written] {
            let db = &workspace.db;
            let codes: BTreeSet<&str> = rules::all().iter().map(|rule| rule.code).collect();
            let every = RuleSelection { only: Some(codes.clone()), named: codes, ..RuleSelection::default() };
            let settings = CheckSettings::new(db, WorkspaceSettings::new(db, &workspace.projects, &every).unwrap());
            for project in workspace.projects {
                let whole = own_diagnostics(db, settings, project);
                for file in program_files(db, project) {
                    let expected: Vec<_> = whole.iter().filter(|found| found.place.file == *file).cloned().collect();
                    match program_diagnostics(db, settings, project, *file) {
                        Some(found) => assert_eq!(sorted(found), sorted(expected.clone())),
                        None => assert!(whole.iter().any(|found| is_once_per_application(found.rule))),
                    }
                    judged.extend(expected.iter().map(|found| found.rule.code));
                }
            }
        }
        // An unresolved library is a finding of the project, and an unused suppression comment a finding of the
        // application.
        assert!(["V0604", "V0702", "V0114"].iter().all(|code| judged.contains(code)), "{judged:?}");
    }

    fn sorted(mut found: Vec<Diagnostic>) -> Vec<Diagnostic> {
        found.sort_by_key(|found| (found.place.range.start(), found.rule.code, found.message.clone()));
        found
    }

    #[test]
    fn an_edit_validates_nothing_of_unrelated_projects() {
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
        let settings = WorkspaceSettings::new(&workspace.db, &workspace.projects, &RuleSelection::default()).unwrap();
        let settings = CheckSettings::builder(settings).durability(Durability::MEDIUM).new(&workspace.db);
        let other = Sources::get(&workspace.db).files(&workspace.db).iter().find(|(path, _)| path.contains("other"));
        let (_, other) = other.unwrap();
        let other = *other;
        for number in 0..3 {
            let text = other.text(&workspace.db).replace("nB=", &format!("nB={number}"));
            other.set_text(&mut workspace.db).with_durability(Durability::LOW).to(text.into());
            looked.lock().unwrap().clear();
            workspace.projects.iter().for_each(|project| _ = own_diagnostics(&workspace.db, settings, *project));
        }
        // Of the three programs, only the unedited program of the edited project is inferred again.
        let looked = looked.lock().unwrap();
        assert_eq!(looked.iter().filter(|name| name.starts_with("infer(")).count(), 1, "{looked:?}");
    }
}
