mod check;
mod new_dialect;
mod old_dialect;
mod refusals;

use expect_test::Expect;
use val3_lang::types::Container;

use super::*;
use crate::assists::shown;
use crate::data_tables::{DataPlace, FieldStep};
use crate::testing::MarkedListing;

/// Changed lines in the file of the cursor.
fn done(listing: &str, edits: &[DataEdit]) -> Result<String, DataProblem> {
    let marked = MarkedListing::new(listing);
    let file = marked.at().file;
    let project = crate::owner(marked.db(), file).unwrap();
    let change = data_edits(marked.db(), project, file, edits)?;
    Ok(shown(marked.db(), &change))
}

fn check(listing: &str, edits: &[DataEdit], expected: Expect) {
    expected.assert_eq(&done(listing, edits).unwrap());
}

fn refused(listing: &str, edit: DataEdit) -> String {
    done(listing, &[edit]).unwrap_err().reason
}

/// Parses a place: `nList[2]`, `tSlot[0].pPick[0]`, or `pA` for the variable itself.
fn place(path: &str) -> DataPlace {
    let mut steps = path.split('.').map(|step| {
        let (name, key) = step.split_once('[').unwrap_or((step, ""));
        (name.to_owned(), key.trim_end_matches(']').to_owned())
    });
    let (name, key) = steps.next().unwrap();
    let within = steps.map(|(name, key)| FieldStep { name, key }).collect();
    DataPlace { name, key: Some(key).filter(|key| !key.is_empty()), within }
}

/// Edit that sets one cell.
fn set(path: &str, column: &str, text: Option<&str>) -> DataEdit {
    let (place, column, text) = (place(path), column.to_owned(), text.map(str::to_owned));
    DataEdit::Set(vec![CellEdit { place, column, text }])
}

fn add(name: &str, type_name: &str, sizes: &[u32], after: Option<&str>) -> DataEdit {
    let container = match sizes {
        [] => Container::Collection,
        sizes => Container::Array { dims: u8::try_from(sizes.len()).unwrap() },
    };
    let after = after.map(str::to_owned);
    let (name, type_name, sizes) = (name.to_owned(), type_name.to_owned(), sizes.to_vec());
    DataEdit::Add(NewDatum { name, type_name, public: false, container, sizes, after })
}

fn resize(path: &str, sizes: &[u32]) -> DataEdit {
    DataEdit::Resize { place: place(path), sizes: sizes.to_vec() }
}

fn strings(names: &[&str]) -> Vec<String> {
    names.iter().map(|name| (*name).to_owned()).collect()
}
