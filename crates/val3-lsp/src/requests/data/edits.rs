//! Conversion of data editor messages to feature edits.

use val3_ide as ide;
use val3_lang::types;

use super::messages::*;

/// Converts one edit of the tables.
pub(super) fn edit(edit: &DataEdit) -> ide::DataEdit {
    match edit {
        DataEdit::Set { cells } => ide::DataEdit::Set(cells.iter().map(cell).collect()),
        DataEdit::Add { name, type_name, access, container, size, after } => ide::DataEdit::Add(ide::NewDatum {
            name: name.clone(),
            type_name: type_name.clone(),
            public: *access == Access::Public,
            container: shape(*container, size),
            sizes: if *container == Container::Array { size.clone() } else { Vec::new() },
            after: after.clone(),
        }),
        DataEdit::Duplicate { name, new_name } => {
            ide::DataEdit::Duplicate { name: name.clone(), new_name: new_name.clone() }
        }
        DataEdit::Delete { names } => ide::DataEdit::Delete(names.clone()),
        DataEdit::Access { names, access } => {
            ide::DataEdit::Access { names: names.clone(), public: *access == Access::Public }
        }
        DataEdit::Resize { place: at, size } => ide::DataEdit::Resize { place: place(at), sizes: size.clone() },
        DataEdit::AddKey { place: at, key } => ide::DataEdit::AddKey { place: place(at), key: key.clone() },
        DataEdit::RemoveKey { place: at, keys } => ide::DataEdit::RemoveKeys { place: place(at), keys: keys.clone() },
        DataEdit::RenameKey { place: at, key, new_key } => {
            ide::DataEdit::RenameKey { place: place(at), key: key.clone(), new_key: new_key.clone() }
        }
    }
}

fn cell(cell: &CellChange) -> ide::CellEdit {
    ide::CellEdit { place: place(&cell.place), column: cell.column.clone(), text: cell.text.clone() }
}

fn shape(container: Container, size: &[u32]) -> types::Container {
    match container {
        Container::Collection => types::Container::Collection,
        Container::Array => types::Container::Array { dims: u8::try_from(size.len()).unwrap_or(1) },
    }
}

fn place(place: &DataLocation) -> ide::DataPlace {
    let step = |step: &PathStep| ide::FieldStep { name: step.name.clone(), key: step.key.clone() };
    ide::DataPlace { name: place.name.clone(), key: place.key.clone(), within: place.within.iter().map(step).collect() }
}
