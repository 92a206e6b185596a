//! Changes to a file's tables, with their inverses.

use val3_ide::{
    CellEdit, ColumnKind, DataColumn, DataEdit, DataPlace, DataTables, DataType, Dialect, FieldStep, NewDatum,
    TableVariable,
};
use val3_lang::types::Container;

/// Returns for each cell with a value in the file a change to another text and its inverse.
pub(crate) fn other_texts(tables: &DataTables) -> Vec<(DataEdit, DataEdit)> {
    let mut found = Vec::new();
    for data in &tables.data {
        let place = DataPlace { name: data.name.to_string(), ..DataPlace::default() };
        cells(tables, data, &place, &mut found);
    }
    found
}

fn cells(tables: &DataTables, data: &TableVariable, place: &DataPlace, found: &mut Vec<(DataEdit, DataEdit)>) {
    let columns = columns(&tables.types, &data.type_name);
    // In s5 and s6 one cell contains the father of all values.
    let is_shared = |column: &DataColumn| tables.dialect == Dialect::Old && column.kind == ColumnKind::Father;
    for (at, value) in data.values.iter().enumerate() {
        let place = with_key(place, &value.key);
        for (column, text) in columns.iter().zip(&value.texts).filter(|(column, _)| at == 0 || !is_shared(column)) {
            let is_written = text.is_some() || tables.dialect == Dialect::New;
            found.extend(is_written.then(|| pair(&place, column, text.as_deref())));
        }
        for field in &value.fields {
            let mut within = place.clone();
            within.within.push(FieldStep { name: field.name.to_string(), key: String::new() });
            cells(tables, field, &within, found);
        }
    }
}

fn columns<'t>(types: &'t [DataType], name: &str) -> &'t [DataColumn] {
    types.iter().find(|ty| ty.name == name).map_or(&[], |ty| &ty.columns)
}

fn with_key(place: &DataPlace, key: &str) -> DataPlace {
    let mut place = place.clone();
    match place.within.last_mut() {
        Some(step) => key.clone_into(&mut step.key),
        None => place.key = Some(key.to_owned()),
    }
    place
}

fn pair(place: &DataPlace, column: &DataColumn, text: Option<&str>) -> (DataEdit, DataEdit) {
    let set = |text: Option<&str>| {
        let (column, text) = (column.id.to_owned(), text.map(str::to_owned));
        DataEdit::Set(vec![CellEdit { place: place.clone(), column, text }])
    };
    (set(Some(&other_text(column, text))), set(text))
}

/// Returns a text for the column that is neither `text` nor the default.
fn other_text(column: &DataColumn, text: Option<&str>) -> String {
    let candidates = match column.kind {
        ColumnKind::Number => vec!["17.25", "-3e5"],
        ColumnKind::Truth => vec!["true", "false"],
        ColumnKind::Text => vec!["<é> & \"b'\"", "c"],
        ColumnKind::Father => vec!["fNew[1]", "fOther[0]"],
        ColumnKind::Link => vec!["io1[1]", "io2[0]"],
        ColumnKind::Choice => column.choices.iter().map(String::as_str).collect(),
    };
    let is_other = |candidate: &&&str| Some(**candidate) != text && **candidate != column.default;
    // The other truth value is the default.
    (*candidates.iter().find(is_other).unwrap_or(&candidates[1])).to_owned()
}

/// Returns the declarations of `count` variables of a type.
pub(crate) fn added(stem: &str, type_name: &str, sizes: &[u32], count: usize) -> Vec<DataEdit> {
    let container = match sizes {
        [] => Container::Collection,
        sizes => Container::Array { dims: u8::try_from(sizes.len()).unwrap() },
    };
    let new = |number| NewDatum {
        name: format!("{stem}{number}"),
        type_name: type_name.to_owned(),
        public: number % 2 == 1,
        container,
        sizes: sizes.to_vec(),
        after: None,
    };
    (0..count).map(|number| DataEdit::Add(new(number))).collect()
}

/// Returns changes of declarations, sizes and keys with their inverses.
pub(crate) fn pairs(tables: &DataTables) -> Vec<(&'static str, DataEdit, DataEdit)> {
    let mut pairs = Vec::new();
    for ty in &tables.types {
        let shapes: [(bool, &[u32]); 3] = [(ty.has_arrays, &[1]), (ty.has_arrays, &[5]), (ty.has_collections, &[])];
        for (_, sizes) in shapes.into_iter().filter(|(allowed, _)| *allowed) {
            let there = added("zz", &ty.name, sizes, 1).remove(0);
            pairs.push(("add", there, DataEdit::Delete(vec!["zz0".to_owned()])));
        }
    }
    tables.data.iter().for_each(|data| of_data(data, &mut pairs));
    pairs
}

fn of_data(data: &TableVariable, pairs: &mut Vec<(&'static str, DataEdit, DataEdit)>) {
    let name = data.name.to_string();
    let place = DataPlace { name: name.clone(), ..DataPlace::default() };
    let copy = DataEdit::Duplicate { name: name.clone(), new_name: "zz0".to_owned() };
    pairs.push(("copy", copy, DataEdit::Delete(vec!["zz0".to_owned()])));
    let access = |public| DataEdit::Access { names: vec![name.clone()], public };
    pairs.push(("access", access(!data.public), access(data.public)));
    if data.container == Container::Collection {
        let key = || "new <key>".to_owned();
        let add = DataEdit::AddKey { place: place.clone(), key: key() };
        pairs.push(("add key", add, DataEdit::RemoveKeys { place: place.clone(), keys: vec![key()] }));
        let first = data.values[0].key.clone();
        let rename = |key, new_key| DataEdit::RenameKey { place: place.clone(), key, new_key };
        pairs.push(("rename key", rename(first.clone(), key()), rename(key(), first)));
        return;
    }
    let resize = |sizes| DataEdit::Resize { place: place.clone(), sizes };
    let larger = data.sizes.iter().map(|size| size + 2).collect();
    pairs.push(("resize", resize(larger), resize(data.sizes.clone())));
}
