//! Report of positions with their movements.

use std::cmp::Ordering;

use val3_lang::types::BaseType;

use super::block::{Block, ReportMark, ReportRow, TextTable, entry};
use super::changes::fields;
use super::dependents::{self, span};
use super::elements::elements;
use super::groups::{groups, other_fields};
use crate::model::{Change, Displacement, FieldChange, Shift, ValueChange};
use crate::read::number::shown;

/// Adds the positions that differ, the greatest movement first, then the positions that moved with a frame or tool.
pub(super) fn add(values: &[&ValueChange], blocks: &mut Vec<Block>) {
    let mut values = values.to_vec();
    values.sort_by(|one, other| is_pose(other).cmp(&is_pose(one)).then_with(|| by_size(extent(other), extent(one))));
    let (moved, others): (Vec<&ValueChange>, Vec<&ValueChange>) =
        values.into_iter().partition(|value| value.movement.is_some());
    if !moved.is_empty() {
        let titles = vec!["Position", "Moved", "Turned", whole_movement(&moved), "Values"];
        let rows = groups(&moved).iter().filter_map(|group| row(group)).collect();
        blocks.push(Block::Table(TextTable { titles, rows }));
    }
    for group in groups(&others) {
        blocks.extend(values_entry(&group));
    }
    moved.iter().filter(|value| !value.dependents.is_empty()).for_each(|value| dependents::add(value, blocks));
}

/// Returns the movement of a position, in `world` if known; `None` if the movement is unknown.
pub(super) fn extent(value: &ValueChange) -> Option<Displacement> {
    value.movement.map_or(value.axes, |movement| movement.in_world.or(movement.in_father))
}

/// Compares two movements. An unknown movement is the greatest.
pub(super) fn by_size(one: Option<Displacement>, other: Option<Displacement>) -> Ordering {
    match (one, other) {
        (Some(one), Some(other)) => {
            one.distance_mm.total_cmp(&other.distance_mm).then(one.angle_deg.total_cmp(&other.angle_deg))
        }
        (one, other) => one.is_none().cmp(&other.is_none()),
    }
}

/// Formats `12.500 mm, 0.500°`, without zeros.
pub(super) fn displacement(moved: Displacement) -> String {
    if moved.is_zero() { "same place".to_owned() } else { span(&[moved]) }
}

/// Returns a line for values with the same change.
pub(super) fn values_entry(group: &[&ValueChange]) -> Option<Block> {
    let first = group.first()?;
    let text = match (first.change, &first.value) {
        (Change::Changed, _) => fields(&first.fields),
        (_, Some(value)) => format!("= {value}"),
        (_, None) => String::new(),
    };
    Some(entry(first.change.into(), &names(group), text))
}

fn names(group: &[&ValueChange]) -> String {
    match group {
        [value] => value.path.clone(),
        values => elements(&values.iter().map(|value| value.path.as_str()).collect::<Vec<_>>()),
    }
}

/// Whether the change has a displacement, of a pose or of axes.
pub(super) fn is_pose(value: &ValueChange) -> bool {
    value.movement.is_some() || value.axes.is_some()
}

/// Returns the title of the column for the entire movement. Tools move on the flange.
fn whole_movement(moved: &[&ValueChange]) -> &'static str {
    let tools = moved.iter().filter(|value| value.type_name == BaseType::Tool.name()).count();
    match (tools > 0, tools == moved.len()) {
        (true, true) => "On flange",
        (true, false) => "In world, on flange",
        _ => "In world",
    }
}

fn row(group: &[&ValueChange]) -> Option<ReportRow> {
    let value = group.first()?;
    let in_father = value.movement.and_then(|movement| movement.in_father);
    let in_world: Vec<Displacement> = group.iter().filter_map(|value| value.movement?.in_world).collect();
    let moved = match in_father {
        None => "other father".to_owned(),
        Some(found) if found.is_zero() => "same place".to_owned(),
        Some(found) => nonzero(found.distance_mm, millimetres),
    };
    let in_world = match in_world.as_slice() {
        [] => String::new(),
        all if all.iter().all(Displacement::is_zero) => "same place".to_owned(),
        all => span(all),
    };
    let values = match (group, value.movement.and_then(|movement| movement.shift)) {
        ([_, _, ..], Some(shift)) => shared(shift, &other_fields(value)),
        _ => fields(&value.fields),
    };
    let angle = in_father.map_or(String::new(), |found| nonzero(found.angle_deg, degrees));
    Some(ReportRow { mark: ReportMark::from(value.change), cells: vec![names(group), moved, angle, in_world, values] })
}

/// Formats the common movement of several positions, `x +1.5, y −2, turned about z`, and the other fields.
fn shared(shift: Shift, others: &[FieldChange]) -> String {
    const AXES: [&str; 3] = ["x", "y", "z"];
    let along = shift.translation_mm.iter().zip(AXES).filter(|(number, _)| **number != 0.0);
    let mut parts: Vec<String> = along.map(|(number, axis)| format!("{axis} {}", signed(*number))).collect();
    let about: Vec<_> = shift.rotation_deg.iter().zip(AXES).filter(|(number, _)| **number != 0.0).collect();
    if let [(number, axis)] = about.as_slice() {
        parts.push(format!("{}° about {axis}", signed(**number)));
    }
    parts.extend((!others.is_empty()).then(|| fields(others)));
    format!("each {}", parts.join(", "))
}

/// Formats `+1.5`, `−2`.
fn signed(number: f64) -> String {
    let sign = if number < 0.0 { '−' } else { '+' };
    format!("{sign}{}", shown(number.abs()))
}

fn nonzero(number: f64, shown: fn(f64) -> String) -> String {
    if number == 0.0 { String::new() } else { shown(number) }
}

/// Formats `12.500 mm`.
pub(super) fn millimetres(distance: f64) -> String {
    format!("{} mm", thousandths(distance))
}

/// Formats `0.500°`.
pub(super) fn degrees(angle: f64) -> String {
    format!("{}°", thousandths(angle))
}

/// Formats with three decimals. A small movement must not look like zero.
fn thousandths(number: f64) -> String {
    if number > 0.0 && number < 0.0005 { "<0.001".to_owned() } else { format!("{number:.3}") }
}
