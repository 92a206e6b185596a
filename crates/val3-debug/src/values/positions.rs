//! Fathers of points, frames and tools, and their placement in `world` or at `flange` (9.4 to 9.6).

use val3_geometry::{Trsf, chain};
use val3_lang::call::{FrameRef, PointRef, ToolRef};
use val3_lang::memory::{Memory, Place};
use val3_lang::references::{self, Chain};
use val3_lang::runtime_errors;
use val3_lang::types::{BaseType, fields};
use val3_lang::values::printed;

use super::look::Look;
use super::{DebugValue, Inside};

/// Largest number of fathers in a chain that are shown.
const MOST: usize = 16;

/// Returns the number of computed parts of a value: its father, and its placement in `world` or at `flange`.
pub(super) fn count(base: BaseType, place: Place) -> usize {
    let is_position = matches!(base, BaseType::Point | BaseType::Frame | BaseType::Tool);
    let is_root = [Memory::WORLD, Memory::FLANGE].contains(&place.store);
    if is_position && !is_root { 2 } else { 0 }
}

/// Returns a computed part.
pub(super) fn part(look: Look<'_>, memory: &Memory, base: BaseType, place: Place, number: usize) -> Option<DebugValue> {
    match number {
        0 => Some(father(look, memory, place)),
        1 => Some(position(memory, base, place)),
        _ => None,
    }
}

/// Returns the father of a position, with the names of all fathers up to `world` or `flange`.
fn father(look: Look<'_>, memory: &Memory, place: Place) -> DebugValue {
    let mut names = Vec::new();
    let mut next = reference(memory, place);
    let first = next;
    while let Some(at) = next.filter(|_| names.len() < MOST) {
        names.push(look.names.of_value(memory, at).unwrap_or_else(|| "?".to_owned()));
        next = reference(memory, at);
    }
    let computed = look.path.computed();
    let look = Look { path: &computed, ..look };
    let kind = first.and_then(|first| Some(memory.store(first.store).ok()?.kind.clone()));
    match first.zip(kind) {
        Some((first, kind)) => {
            let shown = names.join(" -> ");
            DebugValue { shown, ..look.single(memory, FATHER.to_owned(), &kind, first) }
        }
        None => plain(FATHER, "", "none".to_owned()),
    }
}

const FATHER: &str = "father";

/// Returns the father of a position; `None` for `world` and `flange`, which are their own fathers.
fn reference(memory: &Memory, place: Place) -> Option<Place> {
    references::reference(memory, place).ok().flatten().filter(|reference| *reference != place)
}

/// Returns the placement of a position in `world`, or at `flange`.
fn position(memory: &Memory, base: BaseType, place: Place) -> DebugValue {
    let (name, chain) = match base {
        BaseType::Tool => ("flange", references::of_tool(memory, ToolRef(place))),
        BaseType::Frame => ("world", references::of_frame(memory, FrameRef(place))),
        _ => ("world", references::of_point(memory, PointRef(place))),
    };
    match chain {
        Ok(found) => trsf(name, &chain::position(&found, &Chain::new())),
        Err(fault) => {
            let meaning = runtime_errors::find(fault.0).map_or("unknown", |error| error.short);
            plain(name, "trsf", format!("error {}: {meaning}", fault.0))
        }
    }
}

fn trsf(name: &str, value: &Trsf) -> DebugValue {
    let numbers =
        [value.x, value.y, value.z, value.rx, value.ry, value.rz].map(|number| printed::num(number).to_string());
    let shown = printed::structure(&numbers);
    let names = fields(BaseType::Trsf, None).iter().map(|field| field.name);
    let inside = names.zip(numbers).map(|(name, number)| plain(name, "num", number)).collect();
    DebugValue { inside: Inside::listed(inside), ..plain(name, "trsf", shown) }
}

fn plain(name: &str, type_name: &str, shown: String) -> DebugValue {
    let (name, type_name) = (name.to_owned(), type_name.to_owned());
    DebugValue { name, type_name, shown, path: None, refers_to: None, inside: None }
}
