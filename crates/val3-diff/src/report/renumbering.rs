//! Report of arrays with renumbered elements.

use super::block::{Block, ReportMark, entry};
use super::elements::ranges;
use super::points::millimetres;
use crate::model::{Change, DataChange, MovedElements, Renumbering, ValueChange};

/// Number of removed or inserted elements that are shown with their values.
const SHOWN: usize = 4;

/// Adds the changes of elements in an array, and the effect on programs.
pub(super) fn add(change: &DataChange, renumbering: &Renumbering, blocks: &mut Vec<Block>) {
    let edited: Vec<&ValueChange> = change.values.iter().filter(|value| value.change != Change::Changed).collect();
    match one_edit(&change.name, &edited, &renumbering.runs) {
        Some((first, text)) => {
            blocks.push(entry(first.change.into(), &edited_name(&change.name, &edited), text));
            values(&edited, blocks);
        }
        None => {
            for value in &edited {
                blocks.push(entry(value.change.into(), &value.path, value.value.clone().unwrap_or_default()));
            }
            for run in &renumbering.runs {
                let text = format!(
                    "{} is now {}",
                    indexes(&change.name, run.old, run.count),
                    indexes(&change.name, run.new, run.count)
                );
                blocks.push(entry(ReportMark::Note, "", text));
            }
        }
    }
    blocks.push(entry(ReportMark::Note, "", by_index(renumbering)));
}

/// Returns a sentence for the usual edit: consecutive removed or inserted elements, with one run of elements after
/// them.
fn one_edit<'v>(name: &str, edited: &[&'v ValueChange], runs: &[MovedElements]) -> Option<(&'v ValueChange, String)> {
    let ([first, ..], [run]) = (edited, runs) else { return None };
    let (word, direction, start) = match first.change {
        Change::Removed => ("removed", "up", run.old),
        _ => ("inserted", "down", run.new),
    };
    let indexes: Vec<usize> = edited.iter().filter_map(|value| index(name, &value.path)).collect();
    let is_one_edit = edited.iter().all(|value| value.change == first.change)
        && indexes.len() == run.old.abs_diff(run.new)
        && indexes.iter().rev().zip(1..).all(|(index, before)| index + before == start);
    let them = if edited.len() == 1 { "it" } else { "them" };
    let after = if run.count == 1 { format!("element after {them}") } else { format!("{} after {them}", run.count) };
    is_one_edit.then(|| (*first, format!("{word}, the {after} moved {direction} by {}", number(edited.len()))))
}

/// Formats `one`, `2`.
fn number(count: usize) -> String {
    if count == 1 { "one".to_owned() } else { count.to_string() }
}

/// Returns the index in a path: 0 for `pA`, 3 for `pA[3]`.
fn index(name: &str, path: &str) -> Option<usize> {
    match path.strip_prefix(name)? {
        "" => Some(0),
        rest => rest.strip_prefix('[')?.strip_suffix(']')?.parse().ok(),
    }
}

fn edited_name(name: &str, edited: &[&ValueChange]) -> String {
    format!("{name}[{}]", ranges(edited.iter().filter_map(|value| index(name, &value.path)).collect()).join(", "))
}

fn values(edited: &[&ValueChange], blocks: &mut Vec<Block>) {
    for value in edited.iter().take(SHOWN) {
        let Some(text) = &value.value else { continue };
        let name = if edited.len() == 1 { "" } else { &value.path };
        blocks.push(entry(ReportMark::Note, name, text.clone()));
    }
    let more = edited.len().saturating_sub(SHOWN);
    if more > 0 {
        blocks.push(entry(ReportMark::Note, "", format!("and {more} more; `--format json` has all values")));
    }
}

/// Formats `pA[3–9]`.
fn indexes(name: &str, first: usize, count: usize) -> String {
    format!("{name}[{}]", ranges((first..first + count).collect()).join(", "))
}

/// Formats the effect on programs, which address elements by index.
fn by_index(renumbering: &Renumbering) -> String {
    let distance = renumbering.greatest_distance_mm.filter(|distance| *distance > 0.0);
    let distance = distance.map_or(String::new(), |distance| format!(", by up to {}", millimetres(distance)));
    let differ = match renumbering.differing_indexes {
        1 => "1 index differs".to_owned(),
        count => format!("{count} indexes differ"),
    };
    format!("programs address elements by index: {differ}{distance}")
}
