//! Renamed data: data with the same content under another name.

use std::collections::{BTreeMap, BTreeSet};

use super::items::UnmatchedNames;
use crate::read::code::Renames;
use crate::read::data::DataVersion;

/// Minimum number of non-default parts for which content identifies data. Two counters with the value 1 are not the
/// same counter.
const FEWEST_PARTS: usize = 3;

/// Adds the renamed data: data whose uses have a new name, if the types are equal, and data with equal content. The
/// search is repeated, because points may have equal contents once their frame is renamed.
pub(super) fn find(
    [old, new]: [&[DataVersion]; 2],
    names: &UnmatchedNames<'_>,
    followed: &Renames,
    renamed: &mut Renames,
) {
    let find_one = |list: &'_ [DataVersion], name: &str| list.iter().position(|data| data.decl.name == name);
    for (before, after) in followed {
        let before_data = find_one(old, before).and_then(|index| old.get(index));
        let after_data = find_one(new, after).and_then(|index| new.get(index));
        if before_data.zip(after_data).is_some_and(|(before, after)| is_same_kind(before, after)) {
            renamed.insert(before.clone(), after.clone());
        }
    }
    loop {
        let old_names = names.removed.iter().copied().filter(|name| !renamed.contains_key(*name)).collect();
        let new_names: BTreeSet<&str> = renamed.values().map(String::as_str).collect();
        let new_names = &names.added - &new_names;
        let old = by_content(named(old, &old_names), renamed);
        let new = by_content(named(new, &new_names), &Renames::new());
        let pairs = old.iter().filter_map(|(content, names)| match (names.as_slice(), new.get(content)?.as_slice()) {
            ([before], [after]) => Some(((*before).to_owned(), (*after).to_owned())),
            _ => None,
        });
        let pairs: Vec<(String, String)> = pairs.collect();
        if pairs.is_empty() {
            return;
        }
        renamed.extend(pairs);
    }
}

fn named<'d>(all: &'d [DataVersion], names: &BTreeSet<&str>) -> impl Iterator<Item = &'d DataVersion> {
    all.iter().filter(|data| names.contains(data.decl.name.as_str()))
}

fn is_same_kind(old: &DataVersion, new: &DataVersion) -> bool {
    old.type_name() == new.type_name() && old.decl.container == new.decl.container
}

/// Returns data names by content. Data with too little content are omitted.
fn by_content<'d>(all: impl Iterator<Item = &'d DataVersion>, renames: &Renames) -> BTreeMap<String, Vec<&'d str>> {
    let mut found: BTreeMap<String, Vec<&str>> = BTreeMap::new();
    for data in all {
        if data.values.iter().map(|(_, value)| value.differing_parts()).sum::<usize>() < FEWEST_PARTS {
            continue;
        }
        let renamed = data.renamed(renames);
        let values = renamed
            .values
            .iter()
            .filter_map(|(path, value)| Some(format!("{}={}", path.get(renamed.decl.name.len()..)?, value.shown()?)));
        let values: Vec<String> = values.collect();
        let content = format!(
            "{:?} {} {} {values:?} {:?}",
            data.decl.container,
            data.type_name(),
            data.size(),
            data.field_sizes.values()
        );
        found.entry(content).or_default().push(&data.decl.name);
    }
    found
}
