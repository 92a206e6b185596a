//! Dependents: positions that moved because their frame or tool moved.

use rustc_hash::{FxHashMap, FxHashSet};
use smol_str::SmolStr;
use val3_analysis::placement::shown;
use val3_lang::types::BaseType;

use super::movement;
use super::placement::{Places, TreePositions};
use crate::model::{DataChange, Dependent};
use crate::read::data::DataVersion;

/// Adds dependents to every frame and tool that has moved. A position is added to its nearest father that has moved.
pub(super) fn add(changes: &mut [DataChange], new: &[DataVersion], places: &mut Places<'_>) {
    let moved = moved(changes);
    if moved.is_empty() {
        return;
    }
    let mut found: FxHashMap<String, Vec<Dependent>> = FxHashMap::default();
    for path in paths(new) {
        let Some((origin, value)) = places.origin(path).zip(places.new.value(path)) else { continue };
        let Some(father) = nearest(value.father(), &moved, &places.new) else { continue };
        if father == shown(path) {
            // A loop of fathers ends at the frame itself.
            continue;
        }
        let in_world = movement::in_world(&origin, path, places);
        if in_world.is_none_or(|moved| !moved.is_zero()) {
            let dependent = Dependent { path: shown(path), type_name: value.ty.name().to_owned(), in_world };
            found.entry(father).or_default().push(dependent);
        }
    }
    for value in changes.iter_mut().flat_map(|change| &mut change.values) {
        value.dependents = found.remove(&value.path).unwrap_or_default();
    }
}

fn paths(data: &[DataVersion]) -> impl Iterator<Item = &SmolStr> {
    let values = data.iter().flat_map(|data| &data.values);
    values.filter(|(_, value)| value.ty.has_father()).map(|(path, _)| path)
}

/// Returns the data paths of frames and tools that have moved, as displayed.
fn moved(changes: &[DataChange]) -> FxHashSet<String> {
    let values = changes.iter().flat_map(|change| &change.values).filter(|value| value.movement.is_some());
    let fathers = [BaseType::Frame, BaseType::Tool].map(BaseType::name);
    values.filter(|value| fathers.contains(&value.type_name.as_str())).map(|value| value.path.clone()).collect()
}

/// Returns the nearest father that has moved. The search ends at a loop of fathers.
fn nearest(father: Option<&SmolStr>, moved: &FxHashSet<String>, positions: &TreePositions<'_>) -> Option<String> {
    let (mut next, mut seen) = (father.cloned(), FxHashSet::default());
    while let Some(path) = next.filter(|path| seen.insert(path.clone())) {
        let found = shown(&path);
        if moved.contains(&found) {
            return Some(found);
        }
        next = positions.value(&path).and_then(|value| value.father().cloned());
    }
    None
}
