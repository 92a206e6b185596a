//! Report of positions that moved with a frame or tool, by variable.

use std::collections::BTreeMap;

use super::block::{Block, ReportMark, entry};
use super::counts::counted;
use super::elements::{elements, parts};
use super::points::{degrees, millimetres};
use crate::model::{Dependent, Displacement, ValueChange};

/// Adds an entry for the frame or tool, and a line for each variable with the range of movements.
pub(super) fn add(moved: &ValueChange, blocks: &mut Vec<Block>) {
    let count = counted(moved.dependents.len(), "position moves with it", "positions move with it");
    blocks.push(entry(ReportMark::Changed, &moved.path, count));
    let mut groups: BTreeMap<(&str, &str), Vec<&Dependent>> = BTreeMap::new();
    for dependent in &moved.dependents {
        let (name, _, field) = parts(&dependent.path);
        groups.entry((name, field)).or_default().push(dependent);
    }
    for dependents in groups.into_values() {
        let paths: Vec<&str> = dependents.iter().map(|dependent| dependent.path.as_str()).collect();
        blocks.push(entry(ReportMark::Note, &elements(&paths), range(&dependents)));
    }
}

/// Formats `12.500 mm, 0.500°`, or the range from the smallest to the greatest movement.
fn range(dependents: &[&Dependent]) -> String {
    let known: Vec<Displacement> = dependents.iter().filter_map(|dependent| dependent.in_world).collect();
    if known.len() < dependents.len() {
        return "movement unknown, because the fathers do not lead to `world` or the flange".to_owned();
    }
    span(&known)
}

/// Formats `12.500 mm, 0.500°`, or the range from the smallest to the greatest displacement; empty without
/// displacements.
pub(super) fn span(displacements: &[Displacement]) -> String {
    let distances = range_of(displacements.iter().map(|moved| moved.distance_mm), millimetres);
    let angles = range_of(displacements.iter().map(|moved| moved.angle_deg), degrees);
    distances.into_iter().chain(angles).collect::<Vec<_>>().join(", ")
}

/// Formats `12.500 mm` or `12.500 to 14.000 mm`; `None` if all numbers are 0.
fn range_of(numbers: impl Iterator<Item = f64> + Clone, shown: fn(f64) -> String) -> Option<String> {
    if numbers.clone().all(|number| number == 0.0) {
        return None;
    }
    let least = shown(numbers.clone().fold(f64::INFINITY, f64::min));
    let greatest = shown(numbers.fold(0.0, f64::max));
    if least == greatest {
        return Some(least);
    }
    Some(format!("{} to {greatest}", least.trim_end_matches(|last: char| !last.is_ascii_digit())))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(paths: &[(&str, f64)]) -> Vec<String> {
        let dependents = paths.iter().map(|(path, distance_mm)| Dependent {
            path: (*path).to_owned(),
            type_name: "point".to_owned(),
            in_world: Some(Displacement { distance_mm: *distance_mm, angle_deg: 0.0 }),
        });
        let moved = ValueChange {
            path: "fTable".to_owned(),
            change: crate::model::Change::Changed,
            class: crate::ReportClass::Points,
            type_name: "frame".to_owned(),
            value: None,
            fields: Vec::new(),
            movement: None,
            axes: None,
            dependents: dependents.collect(),
        };
        let mut blocks = Vec::new();
        add(&moved, &mut blocks);
        let lines = blocks.iter().map(|block| match block {
            Block::Entry(entry) => format!("{}: {}", entry.name, entry.text),
            _ => String::new(),
        });
        lines.collect()
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
