//! Comparison of a topic's items: repeated names, overlapping and missing addresses.

use std::collections::BTreeSet;

use super::{FaultKind, FileFault, Item, Topic};
use crate::TableKind;

/// Repeated names, overlaps and gaps.
pub(super) fn faults(topic: &Topic) -> Vec<FileFault> {
    TableKind::ALL.into_iter().flat_map(|table| table_faults(topic, table)).collect()
}

fn table_faults(topic: &Topic, table: TableKind) -> Vec<FileFault> {
    let mut items: Vec<&Item> = topic.items.iter().filter(|item| item.table == table).collect();
    let mut names = BTreeSet::new();
    let repeated = items.iter().filter(|item| !names.insert(&item.name));
    let mut faults: Vec<FileFault> =
        repeated.map(|item| fault(item, FaultKind::RepeatedName(item.name.clone()))).collect();
    // Items with the same address stay in the order of the file.
    items.sort_by_key(|item| item.first);
    let mut last: Option<&Item> = None;
    for item in items {
        let end = last.map_or(0, Item::end);
        let first = u32::from(item.first);
        if let Some(other) = last.filter(|_| first < end) {
            let (item_name, other) = (item.name.clone(), other.name.clone());
            faults.push(fault(item, FaultKind::Overlap { item: item_name, other, address: item.first }));
        } else if first > end {
            faults.push(fault(item, FaultKind::Gap { first: end, last: first - 1 }));
        }
        if item.end() > end {
            last = Some(item);
        }
    }
    faults
}

fn fault(item: &Item, kind: FaultKind) -> FileFault {
    FileFault { offset: item.offset, kind }
}
