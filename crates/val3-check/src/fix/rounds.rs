//! Applies fixes in rounds until nothing changes. Fixes that would add an error anywhere are not applied.

use std::collections::BTreeMap;

use camino::Utf8PathBuf;
use rustc_hash::{FxHashMap, FxHashSet};
use val3_analysis::db::File;

use super::apply::{FixedFile, apart, apply, edited_files};
use super::errors::{ErrorCounts, TrialWorkspace};
use crate::diagnostic::{Diagnostic, Fix};
use crate::suppression::silencing;

/// Maximum number of rounds, which limits fixes that undo each other.
const ROUNDS: usize = 100;

/// Maximum number of mistakes in one line that hide each other.
const FOLLOW_UPS: usize = 10;

/// A workspace to which fixes are applied.
pub trait FixTarget: TrialWorkspace {
    /// Error of a failed check.
    type Error;

    /// Returns the findings whose fixes are applied.
    ///
    /// # Errors
    /// The workspace cannot be checked.
    fn findings(&mut self) -> Result<Vec<Diagnostic>, Self::Error>;

    /// As [`findings`](Self::findings), with all occurrences of findings that are reported once per application.
    ///
    /// # Errors
    /// The workspace cannot be checked.
    fn occurrences(&mut self) -> Result<Vec<Diagnostic>, Self::Error>;
}

/// Result of applying fixes.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct AppliedFixes {
    /// Changed files, by path.
    pub files: Vec<FixedFile>,
    /// Number of applied fixes.
    pub count: usize,
    /// Number of fixes that were not applied, because each would add an error.
    pub refused: usize,
    /// Whether another round would change nothing.
    pub settled: bool,
}

/// Applies the safe fixes of the findings, and also the guesses if `guesses` is set. The target keeps the changes.
///
/// # Errors
/// The errors of the target.
pub fn apply_fixes<T: FixTarget>(target: &mut T, guesses: bool) -> Result<AppliedFixes, T::Error> {
    let mut applied = AppliedFixes::default();
    let mut files = BTreeMap::new();
    let mut errors = ErrorCounts::of(target);
    for _ in 0..ROUNDS {
        let found = target.findings()?;
        let fixes = apart(wanted(&found, guesses));
        let mut round = Round { files: edited_files(target.db(), &fixes), target, errors: &errors, guesses };
        let (kept, refused) = round.keep_harmless(fixes)?;
        applied.refused = refused;
        let Some(kept) = kept else {
            applied.settled = true;
            break;
        };
        applied.count += kept.count;
        kept.changes.into_iter().for_each(|change| add(&mut files, change));
        errors = kept.errors;
    }
    applied.files = files.into_values().filter(|file| file.before != file.after).collect();
    Ok(applied)
}

/// Writes comments into the programs that silence the findings. The target keeps the changes.
///
/// # Errors
/// The errors of the target.
pub fn add_suppressions<T: FixTarget>(target: &mut T) -> Result<AppliedFixes, T::Error> {
    let mut applied = AppliedFixes::default();
    let mut files = BTreeMap::new();
    let mut found = target.occurrences()?;
    loop {
        let fixes = silencing(target.db(), &found);
        let fixes = apart(&fixes);
        let mut edited = edited_files(target.db(), &fixes);
        apply(&mut edited, &fixes);
        let changes: Vec<FixedFile> = edited.into_values().collect();
        set_texts(target, &changes);
        let left = target.occurrences()?;
        if left.len() >= found.len() {
            target.set_texts(changes.iter().map(|change| (change.path.as_path(), &change.before)));
            applied.settled = true;
            break;
        }
        applied.count += found.len() - left.len();
        changes.into_iter().for_each(|change| add(&mut files, change));
        found = left;
    }
    applied.files = files.into_values().collect();
    Ok(applied)
}

fn wanted<'d>(found: impl IntoIterator<Item = &'d Diagnostic>, guesses: bool) -> impl Iterator<Item = &'d Fix> {
    let fixes = found.into_iter().filter_map(|diagnostic| diagnostic.fix.as_ref());
    fixes.filter(move |fix| fix.safe || guesses)
}

/// Adds a changed file. If the file was changed before, its original text is kept.
fn add(files: &mut BTreeMap<Utf8PathBuf, FixedFile>, change: FixedFile) {
    match files.get_mut(&change.path) {
        Some(known) => known.after = change.after,
        None => drop(files.insert(change.path.clone(), change)),
    }
}

/// One round: fixes that can be applied together.
struct Round<'t, T> {
    target: &'t mut T,
    /// Files that the fixes edit.
    files: FxHashMap<File, FixedFile>,
    /// Errors before the round.
    errors: &'t ErrorCounts,
    guesses: bool,
}

/// Result of applying a set of fixes temporarily.
struct Attempt {
    /// Number of applied fixes.
    count: usize,
    /// Changed files, in order.
    changes: Vec<FixedFile>,
    /// Errors after the change.
    errors: ErrorCounts,
    /// Files with new errors.
    faulty: FxHashSet<Utf8PathBuf>,
    /// Whether the first fixes revealed errors whose fixes were applied as well.
    followed_up: bool,
}

impl<T: FixTarget> Round<'_, T> {
    /// Applies as many of the fixes as possible without adding an error. Returns the last attempt and the number of
    /// omitted fixes. If a group of fixes adds an error, its parts are tried one after the other.
    fn keep_harmless(&mut self, fixes: Vec<&Fix>) -> Result<(Option<Attempt>, usize), T::Error> {
        let mut kept: Vec<&Fix> = Vec::new();
        let mut best = None;
        let mut refused = 0;
        let mut open = vec![fixes];
        while let Some(group) = open.pop() {
            if group.is_empty() {
                continue;
            }
            let trial = [kept.as_slice(), &group].concat();
            let attempt = self.attempt(&trial)?;
            if attempt.faulty.is_empty() {
                kept = trial;
                // The remaining fixes refer to a text that has changed. The next round finds them once more.
                let ends_round = attempt.followed_up;
                best = Some(attempt);
                if ends_round {
                    break;
                }
                continue;
            }
            self.undo(&attempt);
            let is_alone = group.len() == 1;
            let (suspects, mut others): (Vec<&Fix>, Vec<&Fix>) =
                group.into_iter().partition(|fix| is_alone || self.edits_one_of(fix, &attempt.faulty));
            if suspects.is_empty() {
                let second = others.split_off(others.len() / 2);
                open.extend([second, others]);
                continue;
            }
            let (first, second) = halves_of_files(suspects);
            if second.is_empty() {
                // Each file with new errors has one fix.
                refused += first.len();
            } else {
                open.extend([second, first]);
            }
            open.push(others);
        }
        if let Some(best) = &best {
            set_texts(self.target, &best.changes);
        }
        Ok((best, refused))
    }

    /// Applies these fixes, and then the fixes of errors that they reveal.
    fn attempt(&mut self, fixes: &[&Fix]) -> Result<Attempt, T::Error> {
        apply(&mut self.files, fixes);
        let mut changes: Vec<FixedFile> = self.files.values().cloned().collect();
        set_texts(self.target, &changes);
        let mut count = fixes.len();
        let mut follow_ups = 0;
        loop {
            let errors = ErrorCounts::of(self.target);
            let faulty = errors.files_with_more_than(self.errors);
            if !faulty.is_empty() && follow_ups < FOLLOW_UPS {
                let (more, fixes) = self.follow_up(&errors)?;
                if fixes > 0 {
                    follow_ups += 1;
                    count += fixes;
                    changes.extend(more);
                    continue;
                }
            }
            return Ok(Attempt { count, changes, errors, faulty, followed_up: follow_ups > 0 });
        }
    }

    /// Applies the fixes of new errors: a mistake often hides the next one on its line.
    fn follow_up(&mut self, errors: &ErrorCounts) -> Result<(Vec<FixedFile>, usize), T::Error> {
        let found = self.target.findings()?;
        let db = self.target.db();
        let new = found.iter().filter(|found| errors.adds(db, found, self.errors));
        let fixes = apart(wanted(new, self.guesses));
        let mut files = edited_files(db, &fixes);
        apply(&mut files, &fixes);
        let changes: Vec<FixedFile> = files.into_values().collect();
        set_texts(self.target, &changes);
        Ok((changes, fixes.len()))
    }

    fn undo(&mut self, attempt: &Attempt) {
        let back = attempt.changes.iter().rev();
        self.target.set_texts(back.map(|change| (change.path.as_path(), &change.before)));
    }

    fn edits_one_of(&self, fix: &Fix, files: &FxHashSet<Utf8PathBuf>) -> bool {
        let edited = fix.edits.iter().filter_map(|edit| self.files.get(&edit.file));
        edited.into_iter().any(|file| files.contains(&file.path))
    }
}

/// Splits the fixes into the first and the second half per file; the second half is empty if no file has two fixes.
fn halves_of_files(fixes: Vec<&Fix>) -> (Vec<&Fix>, Vec<&Fix>) {
    let file = |fix: &Fix| fix.edits.first().map(|edit| edit.file);
    let mut counts: FxHashMap<Option<File>, usize> = FxHashMap::default();
    for fix in &fixes {
        *counts.entry(file(fix)).or_default() += 1;
    }
    counts.values_mut().for_each(|count| *count = count.div_ceil(2));
    fixes.into_iter().partition(|fix| {
        let left = counts.entry(file(fix)).or_default();
        let is_first = *left > 0;
        *left = left.saturating_sub(1);
        is_first
    })
}

fn set_texts<T: FixTarget>(target: &mut T, changes: &[FixedFile]) {
    target.set_texts(changes.iter().map(|change| (change.path.as_path(), &change.after)));
}
