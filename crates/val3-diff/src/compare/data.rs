//! Comparison of data.

use std::collections::BTreeMap;

use val3_analysis::paths::path_key;
use val3_lang::types::{Arm, BaseType};

use super::dependents;
use super::interface;
use super::placement::{Places, TreePositions};
use super::values;
use crate::model::ReportClass;
use crate::model::{Change, DataChange, InterfaceChange, TreeSide, ValuePair};
use crate::read::code::Renames;
use crate::read::data::DataVersion;
use crate::read::program::access;

/// Data that differ.
#[derive(Debug, Default)]
pub(super) struct DataComparison {
    pub(super) data: Vec<DataChange>,
    pub(super) interface: Vec<InterfaceChange>,
    /// Loops of fathers.
    pub(super) problems: Vec<(TreeSide, String)>,
}

/// Compares data. `units` are the length units in mm, `renames` the new names of data.
pub(super) fn compare([original, new]: [&[DataVersion]; 2], units: [f64; 2], renames: &Renames) -> DataComparison {
    let old: Vec<DataVersion> = original.iter().map(|data| data.renamed(renames)).collect();
    let old = old.as_slice();
    let (old_names, new_names) = (indexes_by_name(old), indexes_by_name(new));
    let [old_unit, new_unit] = units;
    let mut places = Places::new(TreePositions::new(old, old_unit), TreePositions::new(new, new_unit));
    let mut names: Vec<&String> =
        old_names.keys().chain(new_names.keys().filter(|name| !old_names.contains_key(*name))).collect();
    names.sort_by_key(|name| (path_key(name), *name));
    let mut found = DataComparison::default();
    for name in names {
        let before = old_names.get(name).and_then(|index| original.get(*index));
        let old = old_names.get(name).and_then(|index| old.get(*index));
        let new = new_names.get(name).and_then(|index| new.get(*index));
        let renamed_from = before.map(|data| data.decl.name.to_string()).filter(|before| before != name);
        let Some(change) = compare_one([old, new], renamed_from, &mut places) else { continue };
        let types = ValuePair { old: before.map(interface_of), new: new.map(interface_of) };
        found.interface.extend(interface::data(&change, types));
        found.data.push(change);
    }
    dependents::add(&mut found.data, new, &mut places);
    found.problems.extend(places.old.loops().map(|message| (TreeSide::Old, message)));
    found.problems.extend(places.new.loops().map(|message| (TreeSide::New, message)));
    found
}

/// Returns the index of each name. If a name is declared twice, the first declaration is used, as in the analysis.
fn indexes_by_name(list: &[DataVersion]) -> BTreeMap<String, usize> {
    list.iter().enumerate().rev().map(|(index, data)| (data.decl.name.to_string(), index)).collect()
}

/// Formats the interface of data for their users, for example `num nA[]`.
fn interface_of(data: &DataVersion) -> String {
    let brackets = val3_analysis::ty::brackets(data.decl.container);
    let is_single = data.decl.sizes == [1];
    format!("{} {}{}", data.type_name(), data.decl.name, if is_single { "" } else { brackets })
}

fn compare_one(
    [old, new]: [Option<&DataVersion>; 2],
    renamed_from: Option<String>,
    places: &mut Places<'_>,
) -> Option<DataChange> {
    let shown = new.or(old)?;
    let change = Change::of(old.is_some(), new.is_some());
    let mut compared = DataChange {
        name: shown.decl.name.to_string(),
        renamed_from,
        change,
        class: ReportClass::of(shown.base.map(|(ty, _)| ty)),
        type_name: shown.type_name().to_owned(),
        declaration: shown.declaration(),
        value: (change != Change::Changed).then(|| shown.single()).flatten(),
        access: None,
        types: None,
        sizes: None,
        public: ValuePair {
            old: old.is_some_and(|data| data.decl.public),
            new: new.is_some_and(|data| data.decl.public),
        },
        renumbering: None,
        values: Vec::new(),
    };
    let (Some(old), Some(new)) = (old, new) else {
        let is_single = shown.decl.sizes == [1] && shown.base.is_some();
        compared.values = if is_single { Vec::new() } else { values::all(shown, change) };
        return Some(compared);
    };
    compared.access = ValuePair::differing(access(old.decl.public), access(new.decl.public));
    if is_same_type(old, new) {
        (compared.values, compared.renumbering) = values::compare(old, new, places);
    } else {
        compared.types = Some(ValuePair { old: old.type_name().to_owned(), new: new.type_name().to_owned() });
    }
    compared.sizes = ValuePair::differing(old.size(), new.size());
    (!compared.is_same()).then_some(compared)
}

/// Whether the types are equal. Each dialect has its own names for types that depend on the kind of arm.
fn is_same_type(old: &DataVersion, new: &DataVersion) -> bool {
    let arm = |(ty, arm): (BaseType, Option<Arm>)| (ty, arm.unwrap_or(Arm::SixAxis));
    match (old.base, new.base) {
        (Some(old), Some(new)) => arm(old) == arm(new),
        (None, None) => old.type_name() == new.type_name(),
        _ => false,
    }
}
