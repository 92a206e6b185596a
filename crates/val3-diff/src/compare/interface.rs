//! Interface of a project for other projects: its public programs and data.

use crate::model::{Change, DataChange, InterfaceChange, ItemKind, ProgramChange, ValuePair};

/// Old and new signature of a changed program: `pick(num, string&)`.
pub(super) type Interfaces = ValuePair<Option<String>>;

/// Returns the change of a public program; `None` if its interface is unchanged.
pub(super) fn program(change: &ProgramChange, interfaces: Interfaces) -> Option<InterfaceChange> {
    let old = interfaces.old.filter(|_| change.public.old);
    let new = interfaces.new.filter(|_| change.public.new);
    item(ItemKind::Program, &change.name, old, new)
}

/// Returns the change of public data. Sizes are ignored, because programs change them.
pub(super) fn data(change: &DataChange, types: Interfaces) -> Option<InterfaceChange> {
    let old = types.old.filter(|_| change.public.old);
    let new = types.new.filter(|_| change.public.new);
    item(ItemKind::Data, &change.name, old, new)
}

fn item(kind: ItemKind, name: &str, old: Option<String>, new: Option<String>) -> Option<InterfaceChange> {
    if old == new {
        return None;
    }
    let change = Change::of(old.is_some(), new.is_some());
    Some(InterfaceChange { kind, name: name.to_owned(), change, old, new, breaks_users: change != Change::Added })
}
