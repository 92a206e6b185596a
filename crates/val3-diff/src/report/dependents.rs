//! Positions that moved with a frame or tool, by variable.

use std::collections::BTreeMap;

use super::block::{Block, Mark, entry};
use super::counts::counted;
use super::points::{degrees, millimetres};
use crate::model::{Dependent, Displacement, ValueChange};

/// Adds an entry for the frame or tool, and a line for each variable with the range of its movements.
pub(super) fn add(moved: &ValueChange, blocks: &mut Vec<Block>) {
    let count = counted(moved.dependents.len(), "position moves with it", "positions move with it");
    blocks.push(entry(Mark::Changed, &moved.path, count));
    let mut groups: BTreeMap<(&str, &str), Vec<&Dependent>> = BTreeMap::new();
    for dependent in &moved.dependents {
        let (name, _, field) = parts(&dependent.path);
        groups.entry((name, field)).or_default().push(dependent);
    }
    for ((name, field), dependents) in groups {
        let keys = keys(&dependents);
        let text = range(&dependents);
        blocks.push(entry(Mark::Note, &format!("{name}{keys}{field}"), text));
    }
}

/// Variable, key and field: `tSlot`, `3`, `.pPick` of `tSlot[3].pPick`.
fn parts(path: &str) -> (&str, &str, &str) {
    let Some((name, rest)) = path.split_once('[') else {
        return path
            .split_once('.')
            .map_or((path, "", ""), |(name, _)| (name, "", path.get(name.len()..).unwrap_or("")));
    };
    let (key, field) = rest.split_once(']').unwrap_or((rest, ""));
    // The first index may belong to a field: `tSlot.pPick[3]`.
    if name.contains('.') { (path, "", "") } else { (name, key, field) }
}

/// `[0–3, 7]`, `["a", "b"]`; empty for single data.
fn keys(dependents: &[&Dependent]) -> String {
    let keys: Vec<&str> = dependents.iter().map(|dependent| parts(&dependent.path).1).collect();
    if keys.iter().all(|key| key.is_empty()) {
        return String::new();
    }
    // An element 0 is shown without an index.
    let number = |key: &&str| if key.is_empty() { Some(0) } else { key.parse::<usize>().ok() };
    let numbers: Option<Vec<usize>> = keys.iter().map(number).collect();
    let (shown, separator) = match numbers {
        Some(numbers) => (ranges(numbers), ", "),
        // Indexes of several dimensions contain commas.
        None => (keys.iter().map(|key| (*key).to_owned()).collect(), "; "),
    };
    format!("[{}]", shown.join(separator))
}

/// `0–3`, `7`
fn ranges(mut numbers: Vec<usize>) -> Vec<String> {
    numbers.sort_unstable();
    let mut found: Vec<(usize, usize)> = Vec::new();
    for number in numbers {
        match found.last_mut() {
            Some((_, last)) if number <= *last + 1 => *last = number,
            _ => found.push((number, number)),
        }
    }
    let shown =
        |(first, last): (usize, usize)| if first == last { first.to_string() } else { format!("{first}–{last}") };
    found.into_iter().map(shown).collect()
}

/// `12.500 mm, 0.500°`, or from the least to the greatest movement.
fn range(dependents: &[&Dependent]) -> String {
    let known: Vec<Displacement> = dependents.iter().filter_map(|dependent| dependent.in_world).collect();
    if known.len() < dependents.len() {
        return "movement unknown, because the fathers do not lead to `world` or the flange".to_owned();
    }
    let distances = span(known.iter().map(|moved| moved.distance_mm), millimetres);
    let angles = span(known.iter().map(|moved| moved.angle_deg), degrees);
    if known.iter().all(|moved| moved.angle_deg == 0.0) { distances } else { format!("{distances}, {angles}") }
}

/// `12.500 mm`, `12.500 to 14.000 mm`
fn span(numbers: impl Iterator<Item = f64> + Clone, shown: fn(f64) -> String) -> String {
    let least = shown(numbers.clone().fold(f64::INFINITY, f64::min));
    let greatest = shown(numbers.fold(0.0, f64::max));
    if least == greatest {
        return least;
    }
    format!("{} to {greatest}", least.trim_end_matches(|last: char| !last.is_ascii_digit()))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(paths: &[(&str, f64)]) -> Vec<String> {
        let dependent = |(path, distance_mm): &(&str, f64)| Dependent {
            path: (*path).to_owned(),
            type_name: "point".to_owned(),
            in_world: Some(Displacement { distance_mm: *distance_mm, angle_deg: 0.0 }),
        };
        let moved = ValueChange {
            path: "fTable".to_owned(),
            change: crate::model::Change::Changed,
            class: crate::Class::Points,
            type_name: "frame".to_owned(),
            value: None,
            fields: Vec::new(),
            movement: None,
            dependents: paths.iter().map(dependent).collect(),
        };
        let mut blocks = Vec::new();
        add(&moved, &mut blocks);
        let line = |block: &Block| match block {
            Block::Entry(entry) => format!("{}: {}", entry.name, entry.text),
            _ => String::new(),
        };
        blocks.iter().map(line).collect()
    }

    #[test]
    fn elements_of_a_variable_share_a_line() {
        let found = shown(&[
            ("pA", 1.0),
            ("pA[1]", 2.0),
            ("pA[7]", 1.0),
            ("tS[\"a\"].pB", 1.0),
            ("tS.pB[2]", 0.0001),
            ("pC", 1.0),
        ]);
        assert_eq!(
            found,
            [
                "fTable: 6 positions move with it",
                "pA[0–1, 7]: 1.000 to 2.000 mm",
                "pC: 1.000 mm",
                "tS[\"a\"].pB: 1.000 mm",
                "tS.pB[2]: <0.001 mm"
            ]
        );
    }
}
