//! Changes of data files through their tables: each change keeps all bytes outside its range, adds no error, and can be
//! undone.

#![allow(clippy::unwrap_used, clippy::indexing_slicing, clippy::panic, reason = "a fault of a test may stop it")]

mod changes;
mod desk;

use std::collections::BTreeMap;

use changes::{added, other_texts, pairs};
use desk::Desk;
use val3_ide::{DataEdit, DataTables, Dialect};
use val3_tests::cell;

/// Number of changes of the same kind, of which one is checked for errors.
const CHECKED: usize = 6;

/// Opens an s6 file with data of every type that can be declared in it.
fn old_desk() -> Desk {
    let sections = [
        "aio", "bool", "dio", "frame", "jointRs", "joint", "mdesc", "num", "pointRs", "point", "sio", "string", "tool",
        "trsf",
    ];
    let lists: String = sections.iter().map(|name| format!("  <{name}Section />\r\n")).collect();
    let text = format!(
        "<?xml version=\"1.0\" encoding=\"iso-8859-1\" ?>\r\n<dataList xmlns=\"DataNameSpace\" >\r\n{lists}</dataList>\r\n"
    );
    let project = "<?xml version=\"1.0\" encoding=\"utf-8\" ?>\n<project xmlns=\"ProjectNameSpace\" >\n  \
        <parameters version=\"s6.8\" stackSize=\"5000\" millimeterUnit=\"true\" />\n  <programSection />\n  <dataSection>\n    \
        <data file=\"old.dtx\" />\n  </dataSection>\n  <aliasSection />\n</project>\n";
    let files =
        [("usrapp/old/old.pjx".to_owned(), project.into()), ("usrapp/old/old.dtx".to_owned(), text.into_bytes())];
    let mut desk = Desk::open(&files).remove(0);
    let edits: Vec<DataEdit> = sections.iter().flat_map(|name| added(&format!("a{name}"), name, &[3], 2)).collect();
    desk.make(&edits);
    desk
}

fn desks() -> Vec<Desk> {
    let mut desks = Desk::open(&cell::files("palletiser"));
    desks.push(old_desk());
    desks
}

#[test]
fn there_are_data_of_every_kind() {
    let tables: Vec<DataTables> = desks().iter().map(Desk::tables).collect();
    let has = |is_wanted: &dyn Fn(&DataTables) -> bool| assert!(tables.iter().any(is_wanted));
    has(&|tables| tables.dialect == Dialect::Old && tables.data.len() > 20);
    has(&|tables| tables.dialect == Dialect::New && tables.data.iter().any(|data| data.sizes.len() == 2));
    has(&|tables| tables.data.iter().any(|data| data.values.iter().any(|value| !value.fields.is_empty())));
}

#[test]
fn every_cell_changes_in_its_variable_and_back() {
    let mut count = 0;
    for desk in desks() {
        for (there, back) in other_texts(&desk.tables()) {
            desk.keeps_others(&there);
            desk.is_undone(&[there, back]);
            count += 1;
        }
    }
    assert!(count > 600, "{count} cells");
}

#[test]
fn all_cells_of_a_file_change_at_once() {
    for desk in desks() {
        let cells = |edits: Vec<DataEdit>| {
            let cells = edits.into_iter().flat_map(|edit| match edit {
                DataEdit::Set(cells) => cells,
                other => panic!("{other:?}"),
            });
            DataEdit::Set(cells.collect())
        };
        let pairs = other_texts(&desk.tables()).into_iter().filter(|(_, back)| !is_spelt_default(back));
        let (there, back): (Vec<_>, Vec<_>) = pairs.unzip();
        desk.is_undone(&[cells(there), cells(back)]);
    }
}

/// Whether the edit writes an explicit default. The examples contain few explicit defaults, and after the last one is
/// removed nothing shows that the file uses them.
fn is_spelt_default(edit: &DataEdit) -> bool {
    let defaults = ["0", "false", "", "50", "100", "99999", "joint", "ssame", "esame", "wsame"];
    let is_default = |text: &Option<String>| text.as_deref().is_some_and(|text| defaults.contains(&text));
    matches!(edit, DataEdit::Set(cells) if cells.iter().any(|cell| is_default(&cell.text)))
}

#[test]
fn declarations_sizes_and_keys_change_and_back() {
    let mut kinds = BTreeMap::new();
    for desk in desks() {
        for (kind, there, back) in pairs(&desk.tables()) {
            desk.keeps_others(&there);
            // Checking a file is much slower than changing it.
            let count: &mut usize = kinds.entry(kind).or_default();
            if count.is_multiple_of(CHECKED) {
                desk.adds_no_error(std::slice::from_ref(&there));
            }
            *count += 1;
            desk.is_undone(&[there, back]);
        }
    }
    let expected = ["access", "add", "add key", "copy", "rename key", "resize"];
    assert_eq!(kinds.into_keys().collect::<Vec<_>>(), expected);
}
