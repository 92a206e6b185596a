//! For the tests of lints: what one rule says about a listing.

use std::collections::BTreeSet;

use camino::Utf8PathBuf;
use val3_analysis::db::{Db, Project};
use val3_analysis::load::load;
use val3_analysis::system::Memory;
use val3_test::{Fixture, ROOT};

use crate::rule::Rule;
use crate::settings::{Selection, WorkspaceSettings};
use crate::{check_unit, units};

/// The findings of `rule` in a listing of `val3-test`: line of the file and its text, message, label, help and
/// related places.
pub(crate) fn check(rule: &Rule, listing: &str) -> String {
    let fixture = Fixture::parse(listing);
    let files = fixture
        .files
        .iter()
        .map(|(path, text)| (Utf8PathBuf::from(format!("{ROOT}/{path}")), text.clone().into_bytes()));
    let workspace = load(&Memory::new(files), &[Utf8PathBuf::from(ROOT)]).unwrap();
    let db = &workspace.db;
    let settings = settings_for(db, &workspace.projects, rule);
    let found = units(db, &workspace.projects).into_iter().flat_map(|unit| check_unit(db, unit, &settings).findings);
    let mut shown = String::new();
    for diagnostic in found.filter(|diagnostic| diagnostic.rule == rule) {
        let at = |place: crate::diagnostic::Span| {
            let text = place.file.text(db);
            let (start, end) = (usize::from(place.range.start()), usize::from(place.range.end()));
            let line = 1 + text[..start].matches('\n').count();
            let name = place.file.path(db).file_name().unwrap_or("").to_owned();
            format!("{name}:{line} `{}`", text[start..end].lines().next().unwrap_or(""))
        };
        shown += &format!("{} {}\n", at(diagnostic.place), diagnostic.message);
        let parts = [("|", &diagnostic.label), ("?", &diagnostic.help)];
        shown
            .extend(parts.iter().filter(|(_, part)| !part.is_empty()).map(|(sign, part)| format!("  {sign} {part}\n")));
        shown.extend(diagnostic.related.iter().map(|note| format!("  > {} {}\n", at(note.place), note.message)));
        shown.extend(
            diagnostic.fix.iter().map(|fix| format!("  ! {}{}\n", fix.title, if fix.safe { "" } else { " (unsafe)" })),
        );
    }
    shown
}

/// Settings that ask for one rule, also where it is off by default.
pub(crate) fn settings_for(db: &dyn Db, projects: &[Project], rule: &Rule) -> WorkspaceSettings {
    let only = BTreeSet::from([rule.code]);
    let selection = Selection { only: Some(only.clone()), named: only, ..Selection::default() };
    WorkspaceSettings::new(db, projects, &selection).unwrap()
}
