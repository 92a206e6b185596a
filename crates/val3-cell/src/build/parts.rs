//! Parts of a cell file.

use std::sync::Arc;

use crate::build::CellMaker;
use crate::carriers::{Carried, CarriedKeys};
use crate::error::CellError;
use crate::file::PartEntry;
use crate::part::Part;
use crate::poses::{check_colour, distance, triple};
use crate::solids::{ShapedEntry, SolidMaker, solids};

/// Maximum number of copies.
const MOST_COPIES: u32 = 1000;

/// Returns the names of the parts that an entry describes: the entry's name, or one name for each copy.
pub(super) fn names(entry: &PartEntry) -> Vec<String> {
    match entry.copies {
        None => vec![entry.name.clone()],
        Some(count) => (0..count).map(|index| format!("{}[{index}]", entry.name)).collect(),
    }
}

impl CellMaker<'_> {
    /// Builds the parts. The parts named in `fed` are outside of the cell at the start.
    pub(super) fn parts(&mut self, entries: &[PartEntry], fed: &[&str]) -> Result<Vec<Part>, CellError> {
        let parts = entries.iter().enumerate().map(|(index, entry)| {
            let mut parts = self.copies(entry, &format!("part[{index}]"))?;
            let is_outside = fed.contains(&entry.name.as_str());
            parts.iter_mut().for_each(|part| part.is_outside = is_outside);
            Ok(parts)
        });
        Ok(parts.collect::<Result<Vec<_>, _>>()?.concat())
    }

    /// Builds a part and its copies; empty if the application does not have its frame.
    fn copies(&mut self, entry: &PartEntry, key: &str) -> Result<Vec<Part>, CellError> {
        let PartEntry { name, carrier, at, copies, step, touch, shapes, clearance, colour, shape } = entry;
        if copies.is_some_and(|count| count == 0 || count > MOST_COPIES) {
            let message = format!("{} is no number of copies", copies.unwrap_or_default());
            return Err(CellError::new(format!("{key}.copies"), message, format!("write 1 to {MOST_COPIES}")));
        }
        if copies.is_none() && !step.is_empty() {
            let help = "add `copies`, or remove `step`";
            return Err(CellError::new(format!("{key}.step"), "one part has no next copy", help));
        }
        if let Some(index) = shapes.iter().map(|entry| &entry.shape).chain([shape]).position(|keys| keys.hull.is_some())
        {
            let key = if index < shapes.len() { format!("{key}.shapes[{index}].hull") } else { format!("{key}.hull") };
            return Err(CellError::new(key, "a part is always the convex hull of its mesh", "remove `hull`"));
        }
        let step = if step.is_empty() { [0.0; 3] } else { triple(step, &format!("{key}.step"))? };
        let in_frame = CarriedKeys { carrier: carrier.as_deref().unwrap_or("world"), at: &[], key };
        let origin = self.carriers.of(in_frame, self.surroundings)?.map(|carried| carried.pose).unwrap_or_default();
        let mut placed = Vec::new();
        for index in 0..copies.unwrap_or(1) {
            let at = shifted(at, &step, f64::from(index));
            let keys = CarriedKeys { at: &at, ..in_frame };
            placed.extend(self.carriers.of(keys, self.surroundings)?);
        }
        let Some(first) = placed.first() else {
            self.missing.push(name.clone());
            return Ok(Vec::new());
        };
        if first.carrier.is_arm() {
            let message = format!("the arm cannot carry the part `{name}` from the start");
            let help = "let a gripper hold it, or describe it as an object";
            return Err(CellError::new(format!("{key}.in"), message, help));
        }
        let touch = distance(*touch, &format!("{key}.touch"))?;
        let clearance = clearance.map(|least| distance(least, &format!("{key}.clearance"))).transpose()?;
        let colour = colour.as_deref().map(|colour| check_colour(colour, key)).transpose()?;
        let maker = SolidMaker { surroundings: &mut *self.surroundings, is_carried: true };
        let solids = Arc::new(solids(ShapedEntry { name, shapes, shape }, key, maker)?);
        let parts = names(entry).into_iter().zip(placed).map(|(name, Carried { carrier, pose })| {
            let (colour, solids) = (colour.clone(), Arc::clone(&solids));
            Part { name, carrier, origin, pose, is_outside: false, solids, touch, clearance, colour }
        });
        Ok(parts.collect())
    }
}

/// Shifts a pose of the file by `times` steps.
fn shifted(at: &[f64], step: &[f64; 3], times: f64) -> Vec<f64> {
    let mut at = if at.is_empty() { vec![0.0; 3] } else { at.to_vec() };
    at.iter_mut().zip(step).for_each(|(coordinate, length)| *coordinate += length * times);
    at
}
