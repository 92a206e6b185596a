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
