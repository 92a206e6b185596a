//! Returns programs after their fixes, for tests.

use camino::Utf8PathBuf;
use val3_analysis::load::load;
use val3_analysis::system::Memory;
use val3_test::{Fixture, ROOT};

use crate::lint::testing::settings_for;
use crate::rule::Rule;
use crate::{check_unit, units};

/// Code of the program `start` of a listing after every fix of `rule`, applied from the last to the first.
pub(crate) fn fixed(rule: &Rule, listing: &str) -> String {
    let files = Fixture::parse(listing).files.into_iter();
    let files = files.map(|(path, text)| (Utf8PathBuf::from(format!("{ROOT}/{path}")), text.into_bytes()));
    let workspace = load(&Memory::new(files), &[Utf8PathBuf::from(ROOT)]).unwrap();
    let db = &workspace.db;
    let settings = settings_for(db, &workspace.projects, rule);
    let mut edits = Vec::new();
    let mut text = String::new();
    for unit in units(db, &workspace.projects).into_iter().filter(|unit| unit.file(db).path(db).ends_with("start.pgx"))
    {
        text = unit.file(db).text(db).to_string();
        let found = check_unit(db, unit, &settings).findings.into_iter();
        let fixes = found.filter(|found| found.rule == rule).filter_map(|found| found.fix);
        edits.extend(fixes.flat_map(|fix| fix.edits));
    }
    edits.sort_by_key(|edit| std::cmp::Reverse(edit.range.start()));
    for edit in edits {
        text.replace_range(std::ops::Range::<usize>::from(edit.range), &edit.text);
    }
    let code = text.split_once("begin").unwrap().1;
    code.split_once("]]>").unwrap_or((code, "")).0.trim_start().to_owned()
}
