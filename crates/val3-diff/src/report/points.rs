//! Positions, and how far they moved.

use val3_lang::types::BaseType;

use super::block::{Block, Mark, Row, Table, entry};
use super::changes::fields;
use super::dependents;
use crate::model::{Change, Displacement, ValueChange};

/// Adds the positions that differ, then those that moved with a frame or tool.
pub(super) fn add(values: &[&ValueChange], blocks: &mut Vec<Block>) {
    let (moved, others): (Vec<&ValueChange>, Vec<&ValueChange>) =
        values.iter().partition(|value| value.movement.is_some());
    if !moved.is_empty() {
        let titles = vec!["Position", "Moved", "Turned", whole_movement(&moved), "Values"];
        blocks.push(Block::Table(Table { titles, rows: moved.into_iter().map(row).collect() }));
    }
    for value in others {
        let text = match value.change {
            Change::Changed => fields(&value.fields),
            _ => value.value.clone().unwrap_or_default(),
        };
        blocks.push(entry(value.change.into(), &value.path, text));
    }
    values.iter().filter(|value| !value.dependents.is_empty()).for_each(|value| dependents::add(value, blocks));
}

/// The title of the column with the movement as a whole. Tools move on the flange.
fn whole_movement(moved: &[&ValueChange]) -> &'static str {
    let is_tool = |value: &&ValueChange| value.type_name == BaseType::Tool.name();
    match (moved.iter().any(is_tool), moved.iter().all(is_tool)) {
        (true, true) => "On flange",
        (true, false) => "In world, on flange",
        _ => "In world",
    }
}

fn row(value: &ValueChange) -> Row {
    let in_father = value.movement.and_then(|movement| movement.in_father);
    let in_world = value.movement.and_then(|movement| movement.in_world);
    let moved = match in_father {
        None => "other father".to_owned(),
        Some(found) if found.is_zero() => "same place".to_owned(),
        Some(found) => nonzero(found.distance_mm, millimetres),
    };
    let cells = vec![
        value.path.clone(),
        moved,
        in_father.map_or(String::new(), |found| nonzero(found.angle_deg, degrees)),
        in_world.map_or(String::new(), both),
        fields(&value.fields),
    ];
    Row { mark: Mark::from(value.change), cells }
}

/// `12.500 mm, 0.500°`, without what is zero.
fn both(moved: Displacement) -> String {
    if moved.is_zero() {
        return "same place".to_owned();
    }
    let parts = [nonzero(moved.distance_mm, millimetres), nonzero(moved.angle_deg, degrees)];
    parts.into_iter().filter(|part| !part.is_empty()).collect::<Vec<_>>().join(", ")
}

fn nonzero(number: f64, shown: fn(f64) -> String) -> String {
    if number == 0.0 { String::new() } else { shown(number) }
}

/// `12.500 mm`
pub(super) fn millimetres(distance: f64) -> String {
    format!("{} mm", thousandths(distance))
}

/// `0.500°`
pub(super) fn degrees(angle: f64) -> String {
    format!("{}°", thousandths(angle))
}

/// A small movement must not look like none.
fn thousandths(number: f64) -> String {
    if number > 0.0 && number < 0.0005 { "<0.001".to_owned() } else { format!("{number:.3}") }
}
