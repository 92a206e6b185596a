//! From fixes to new texts.

use std::ops::Range;

use rustc_hash::FxHashMap;
use val3_analysis::db::{Db, File};
use val3_analysis::items::faults::text_faults;
use val3_syntax::parse;

use crate::diagnostic::{Edit, Fix};

/// What some fixes make of the files.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Mended {
    /// The files that change, with their new text, in the order of their paths.
    pub texts: Vec<(File, String)>,
    /// How many fixes were applied.
    pub fixes: usize,
}

/// Applies fixes to the texts of the database, which stays as it is. Of fixes that touch each other the first is
/// applied; the others come in the next round, when their ranges are known again. A fix that would give a file more
/// faults of its text than it has is left out.
pub fn mend<'f>(db: &dyn Db, fixes: impl IntoIterator<Item = &'f Fix>) -> Mended {
    let mut chosen = apart(fixes);
    if !is_sound(db, &chosen) {
        chosen.retain(|fix| is_sound(db, &[fix]));
    }
    if !is_sound(db, &chosen) {
        chosen.truncate(1);
    }
    Mended { texts: texts(db, &chosen), fixes: chosen.len() }
}

/// The fixes that change something and do not touch an earlier one.
fn apart<'f>(fixes: impl IntoIterator<Item = &'f Fix>) -> Vec<&'f Fix> {
    let mut taken: FxHashMap<File, Vec<Range<u32>>> = FxHashMap::default();
    let mut chosen = Vec::new();
    for fix in fixes {
        let is_free = |edit: &Edit| {
            let range = range(edit);
            let others = taken.get(&edit.place.file);
            others.is_none_or(|others| others.iter().all(|other| other.end < range.start || range.end < other.start))
        };
        if !fix.edits.is_empty() && fix.edits.iter().all(is_free) {
            chosen.push(fix);
            fix.edits.iter().for_each(|edit| taken.entry(edit.place.file).or_default().push(range(edit)));
        }
    }
    chosen
}

fn range(edit: &Edit) -> Range<u32> {
    edit.place.range.start().into()..edit.place.range.end().into()
}

/// No file has more faults of its text than before.
fn is_sound(db: &dyn Db, fixes: &[&Fix]) -> bool {
    let is_sound = |(file, text): &(File, String)| parse(text).errors().len() <= text_faults(db, *file).errors.len();
    texts(db, fixes).iter().all(is_sound)
}

/// The new texts of the files that `fixes` change.
fn texts(db: &dyn Db, fixes: &[&Fix]) -> Vec<(File, String)> {
    let mut edits: FxHashMap<File, Vec<&Edit>> = FxHashMap::default();
    for edit in fixes.iter().flat_map(|fix| &fix.edits) {
        edits.entry(edit.place.file).or_default().push(edit);
    }
    let mut texts: Vec<_> = edits.into_iter().map(|(file, edits)| (file, edited(file.text(db), edits))).collect();
    texts.sort_by(|(a, _), (b, _)| a.path(db).cmp(b.path(db)));
    texts
}

/// `text` with edits that do not overlap.
fn edited(text: &str, mut edits: Vec<&Edit>) -> String {
    edits.sort_by_key(|edit| edit.place.range.start());
    let mut new = String::with_capacity(text.len());
    let mut rest = 0;
    for edit in edits {
        let Range { start, end } = edit.place.range.into();
        new.push_str(text.get(rest..start).unwrap_or(""));
        new.push_str(&edit.text);
        rest = end;
    }
    new.push_str(text.get(rest..).unwrap_or(""));
    new
}

#[cfg(test)]
mod tests {
    use camino::Utf8PathBuf;
    use val3_analysis::load::{Workspace, load};
    use val3_analysis::system::Memory;
    use val3_syntax::TextRange;
    use val3_test::{Fixture, ROOT};

    use super::*;
    use crate::diagnostic::Span;

    const PROGRAM: &str = "start.pgx";

    fn workspace() -> Workspace {
        let files = Fixture::parse("num nA\nnA=1\nnA=2").files;
        let files = files.into_iter().map(|(path, text)| (format!("{ROOT}/{path}"), text.into_bytes()));
        load(&Memory::new(files), &[Utf8PathBuf::from(ROOT)]).unwrap()
    }

    /// A fix that writes `new` over each `old` of the program.
    fn fix(workspace: &Workspace, changes: &[(&str, &str)]) -> Fix {
        let files = val3_analysis::db::Sources::get(&workspace.db).files(&workspace.db);
        let file = *files.values().find(|file| file.path(&workspace.db).as_str().ends_with(PROGRAM)).unwrap();
        let text = file.text(&workspace.db);
        let edit = |(old, new): &(&str, &str)| {
            let start = u32::try_from(text.find(old).unwrap()).unwrap();
            let range = TextRange::at(start.into(), u32::try_from(old.len()).unwrap().into());
            Edit { place: Span { file, range }, text: (*new).to_owned() }
        };
        Fix::safe("", changes.iter().map(edit).collect())
    }

    /// The statements after fixes, and how many were applied.
    fn mended(changes: &[&[(&str, &str)]]) -> (Vec<String>, usize) {
        let workspace = workspace();
        let fixes: Vec<_> = changes.iter().map(|changes| fix(&workspace, changes)).collect();
        let mended = mend(&workspace.db, &fixes);
        let text = mended.texts.first().map_or("", |(_, text)| text);
        let code = text.split("begin\n").nth(1).unwrap_or("").split("\nend").next().unwrap_or("");
        (code.lines().map(str::to_owned).collect(), mended.fixes)
    }

    #[test]
    fn fixes_apart_from_each_other_are_applied_at_once() {
        let (code, fixes) = mended(&[&[("nA=2", "nA=20")], &[("nA=1", "nA=10")]]);
        assert_eq!((code, fixes), (vec!["nA=10".to_owned(), "nA=20".to_owned()], 2));
    }

    #[test]
    fn of_fixes_that_touch_the_first_is_applied() {
        let (code, fixes) = mended(&[&[("A=1", "B=1")], &[("=1", "=3")], &[("nA", "m"), ("=2", "=4")]]);
        assert_eq!((code, fixes), (vec!["nB=1".to_owned(), "nA=2".to_owned()], 1));
    }

    #[test]
    fn a_fix_is_applied_as_a_whole_or_not_at_all() {
        let (code, fixes) = mended(&[&[("=1", "=3")], &[("=1", "=5"), ("=2", "=4")]]);
        assert_eq!((code, fixes), (vec!["nA=3".to_owned(), "nA=2".to_owned()], 1));
    }

    #[test]
    fn what_would_break_the_text_is_left_out() {
        let (code, fixes) = mended(&[&[("nA=1", "nA=(1")], &[("nA=2", "nA=3")]]);
        assert_eq!((code, fixes), (vec!["nA=1".to_owned(), "nA=3".to_owned()], 1));
        assert_eq!(mended(&[&[("nA=1", "nA=(1")]]), (Vec::new(), 0));
    }
}
