//! Differences that a report omits on request: small movements, data with certain names, the layout of code.

mod names;
mod tolerance;

pub use names::NamePattern;
pub use tolerance::Tolerance;

use crate::model::{ApplicationChange, Change, CodeKind, Comparison, DataChange, Ignored, ItemKind, ValueChange};

/// Whether differences in blanks, blank lines and the letter case of keywords count.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum BlankComparison {
    /// They count.
    #[default]
    Compared,
    /// They are ignored.
    Ignored,
}

/// Differences to omit.
#[derive(Debug, Clone, Default)]
pub struct Exclusions {
    /// Maximum movement of positions that is ignored.
    pub tolerance: Option<Tolerance>,
    /// Patterns of data names that are ignored.
    pub names: Vec<NamePattern>,
    /// Whether programs that differ only in layout are ignored.
    pub layout: BlankComparison,
}

impl Comparison {
    /// Removes excluded differences of applications that are in both trees, and counts them in `ignored`.
    pub fn leave_out(&mut self, exclusions: &Exclusions) {
        self.ignored.tolerance = exclusions.tolerance;
        self.ignored.patterns = exclusions.names.iter().map(ToString::to_string).collect();
        for application in self.applications.iter_mut().filter(|application| application.change == Change::Changed) {
            named_data(application, &exclusions.names, &mut self.ignored);
            if let Some(tolerance) = exclusions.tolerance {
                application.data.retain_mut(|data| is_beyond(data, tolerance, &mut self.ignored));
            }
            if exclusions.layout == BlankComparison::Ignored {
                layouts(application, &mut self.ignored);
            }
        }
        self.applications.retain(|application| !application.is_empty());
    }
}

/// Removes data with ignored names, and dependents with ignored names.
fn named_data(application: &mut ApplicationChange, names: &[NamePattern], ignored: &mut Ignored) {
    application.data.retain_mut(|data| {
        if matches_any(names, &data.name) || data.renamed_from.as_deref().is_some_and(|name| matches_any(names, name)) {
            ignored.data += 1;
            ignored.moved_along += data.values.iter().map(|value| value.dependents.len()).sum::<usize>();
            return false;
        }
        for value in &mut data.values {
            remove(&mut value.dependents, |moved| matches_any(names, &moved.path), &mut ignored.moved_along);
        }
        remove(&mut data.values, |value| matches_any(names, &value.path), &mut ignored.data) == 0 || !data.is_same()
    });
    application.interface.retain(|item| item.kind != ItemKind::Data || !matches_any(names, &item.name));
}

fn matches_any(patterns: &[NamePattern], path: &str) -> bool {
    patterns.iter().any(|pattern| pattern.matches(path))
}

/// Whether the data still differ after positions within the tolerance were removed.
fn is_beyond(data: &mut DataChange, tolerance: Tolerance, ignored: &mut Ignored) -> bool {
    if data.change != Change::Changed {
        return true;
    }
    for value in &mut data.values {
        remove(
            &mut value.dependents,
            |dependent| dependent.in_world.is_some_and(|moved| tolerance.includes(moved)),
            &mut ignored.within_tolerance,
        );
    }
    // A frame that moved little may have moved a distant point far.
    let removed = remove(
        &mut data.values,
        |value| value.dependents.is_empty() && is_within(value, tolerance),
        &mut ignored.within_tolerance,
    );
    removed == 0 || !data.is_same()
}

/// Whether a position moved at most by the tolerance and the value has no other difference.
fn is_within(value: &ValueChange, tolerance: Tolerance) -> bool {
    let moved = value.movement.map_or(value.axes, |movement| movement.in_father);
    let is_small = moved.is_some_and(|moved| tolerance.includes(moved));
    value.change == Change::Changed && is_small && value.fields.iter().all(|field| field.is_of_pose())
}

fn layouts(application: &mut ApplicationChange, ignored: &mut Ignored) {
    for program in application.programs.iter_mut().filter(|program| program.code.kind == CodeKind::Layout) {
        ignored.layouts += 1;
        program.code.kind = CodeKind::Same;
        program.code.hunks.clear();
        (program.code.added, program.code.removed) = (0, 0);
    }
    application.programs.retain(|program| program.change != Change::Changed || !program.is_same());
}

/// Removes ignored elements and adds their number to `count`. Returns the number.
fn remove<T>(list: &mut Vec<T>, is_ignored: impl Fn(&T) -> bool, count: &mut usize) -> usize {
    let before = list.len();
    list.retain(|element| !is_ignored(element));
    let removed = before - list.len();
    *count += removed;
    removed
}
