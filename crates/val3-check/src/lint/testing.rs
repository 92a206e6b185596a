//! A rule's findings in a listing, for tests.

use std::collections::BTreeSet;

use camino::Utf8PathBuf;
use val3_analysis::db::{Db, FileRange, Project};
use val3_analysis::load::{Workspace, load};
use val3_analysis::system::Memory;
use val3_test::{Fixture, ROOT};

use crate::diagnostic::Diagnostic;
use crate::rule::{Rule, Severity};
use crate::settings::{RuleSelection, WorkspaceSettings};
use crate::{check_unit, finish, units};

/// Levels of all `rule` findings in a `val3-test` listing.
pub(crate) fn levels(rule: &Rule, listing: &str) -> Vec<Severity> {
    findings(rule, listing).1.into_iter().map(|diagnostic| diagnostic.severity).collect()
}

/// Findings with the code `code` after a complete check of a listing: file, message, and number of related locations.
pub(crate) fn finished(listing: &str, code: &str) -> Vec<String> {
    let fixture = Fixture::parse(listing);
    let files =
        fixture.files.into_iter().map(|(path, text)| (Utf8PathBuf::from(format!("{ROOT}/{path}")), text.into_bytes()));
    let workspace = load(&Memory::new(files), &[Utf8PathBuf::from(ROOT)]).unwrap();
    let db = &workspace.db;
    let units = units(db, &workspace.projects);
    let settings = WorkspaceSettings::new(db, &workspace.projects, &RuleSelection::default()).unwrap();
    let checked = units.iter().map(|unit| check_unit(db, *unit, &settings)).sum();
    let found = finish(db, &units, &settings, checked).findings.into_iter().filter(|found| found.rule.code == code);
    let file = |found: &Diagnostic| found.place.file.path(db).file_name().unwrap_or("").to_owned();
    found.map(|found| format!("{}: {} ({} related)", file(&found), found.message, found.related.len())).collect()
}

fn findings(rule: &Rule, listing: &str) -> (Workspace, Vec<Diagnostic>) {
    let fixture = Fixture::parse(listing);
    let files = fixture
        .files
        .iter()
        .map(|(path, text)| (Utf8PathBuf::from(format!("{ROOT}/{path}")), text.clone().into_bytes()));
    let workspace = load(&Memory::new(files), &[Utf8PathBuf::from(ROOT)]).unwrap();
    let db = &workspace.db;
    let settings = settings_for(db, &workspace.projects, rule);
    let found = units(db, &workspace.projects).into_iter().flat_map(|unit| check_unit(db, unit, &settings).findings);
    let found = found.filter(|diagnostic| diagnostic.rule == rule).collect();
    (workspace, found)
}

/// Findings of `rule` in a listing of `val3-test`: line number and text, message, label, help and related locations.
pub(crate) fn check(rule: &Rule, listing: &str) -> String {
    let (workspace, found) = findings(rule, listing);
    let db = &workspace.db;
    let mut shown = String::new();
    for diagnostic in found {
        shown += &format!("{} {}\n", location(db, diagnostic.place), diagnostic.message);
        let parts = [("|", &diagnostic.label), ("?", &diagnostic.help)];
        shown
            .extend(parts.iter().filter(|(_, part)| !part.is_empty()).map(|(sign, part)| format!("  {sign} {part}\n")));
        let related = diagnostic.related.iter();
        shown.extend(related.map(|note| format!("  > {} {}\n", location(db, note.place), note.message)));
        shown.extend(
            diagnostic.fix.iter().map(|fix| format!("  ! {}{}\n", fix.title, if fix.safe { "" } else { " (unsafe)" })),
        );
    }
    shown
}

/// Formats the file name, the line number and the first line of the text: ``start.pgx:3 `nA` ``.
fn location(db: &dyn Db, place: FileRange) -> String {
    let text = place.file.text(db);
    let (start, end) = (usize::from(place.range.start()), usize::from(place.range.end()));
    let line = 1 + text[..start].matches('\n').count();
    let name = place.file.path(db).file_name().unwrap_or("");
    format!("{name}:{line} `{}`", text[start..end].lines().next().unwrap_or(""))
}

/// Settings that turn on a single rule, even if it is off by default.
pub(crate) fn settings_for(db: &dyn Db, projects: &[Project], rule: &Rule) -> WorkspaceSettings {
    let only = BTreeSet::from([rule.code]);
    let selection = RuleSelection { only: Some(only.clone()), named: only, ..RuleSelection::default() };
    WorkspaceSettings::new(db, projects, &selection).unwrap()
}
