//! New texts in cells, many in one edit.

use rustc_hash::FxHashMap;
use smol_str::SmolStr;
use val3_analysis::items::positions::key_of;
use val3_analysis::ty::Base;
use val3_data::{SavedContainer, SavedContent, SavedData, SavedValue, is_old_reference, same_text};
use val3_lang::types::{AttributeValue, BaseType, attribute};
use val3_syntax::TextEdit;

use super::edit::{CellEdit, refusal};
use super::target::{DataFile, check_text};
use super::{initial, walk};
use crate::data_tables::{DataProblem, Dialect};

/// Sets the texts of cells.
pub(super) fn set(file: &DataFile<'_>, cells: &[CellEdit]) -> Result<Vec<TextEdit>, DataProblem> {
    let mut by_name: FxHashMap<&str, Vec<&CellEdit>> = FxHashMap::default();
    for cell in cells {
        by_name.entry(&cell.place.name).or_default().push(cell);
    }
    let changed: Result<Vec<SavedData>, DataProblem> =
        by_name.into_iter().map(|(name, cells)| EditedVariable::read(file, name)?.set(&cells)).collect();
    Ok(val3_data::edits(file.text, file.root, &changed?))
}

/// A variable with changed values.
struct EditedVariable<'f> {
    file: &'f DataFile<'f>,
    data: SavedData,
    /// Indexes of the values by key.
    places: FxHashMap<String, usize>,
    /// Indexes of the changed values.
    touched: Vec<usize>,
    /// Number of values in the file.
    written: usize,
}

impl<'f> EditedVariable<'f> {
    fn read(file: &'f DataFile<'f>, name: &str) -> Result<Self, DataProblem> {
        let data = val3_data::read(file.element(name)?);
        let values = data.values.iter().enumerate();
        let places = values.map(|(at, value)| (known_key(&data.shape, &value.key), at)).collect();
        let written = data.values.len();
        Ok(Self { file, data, places, touched: Vec::new(), written })
    }

    /// Sets the cells, and returns the data to be written.
    fn set(mut self, cells: &[&CellEdit]) -> Result<SavedData, DataProblem> {
        cells.iter().try_for_each(|cell| self.cell(cell))?;
        let father = cells.iter().rev().find(|cell| cell.column == FATHER);
        let Some(father) = father.filter(|_| self.file.dialect == Dialect::Old) else { return Ok(self.finished()) };
        // In s5 and s6, all values of a variable have the same father.
        let text = father.text.as_deref().unwrap_or("");
        self.data.values.iter_mut().for_each(|value| set_text(value, FATHER, Some(text)));
        Ok(self.data)
    }

    fn cell(&mut self, cell: &CellEdit) -> Result<(), DataProblem> {
        check_text(cell.text.as_deref().unwrap_or(""))?;
        let key = cell.place.key.as_deref().ok_or_else(|| refusal("a cell has the key of its value"))?;
        let key = known_key(&self.data.shape, key);
        let at = self.places.get(&key).copied();
        if self.file.dialect == Dialect::Old && at.is_none() {
            return Err(refusal(format!("the file writes no value `{key}` of `{}`", cell.place.name)));
        }
        let type_name = self.data.type_name.clone();
        let found = walk::variable(self.file, &mut self.data);
        let base = found.base;
        let value = walk::value(self.file, found, &key, at)?;
        nested(self.file, base, type_name, value, cell)?;
        let at = at.unwrap_or(self.data.values.len().saturating_sub(1));
        self.places.entry(key).or_insert(at);
        self.touched.push(at);
        Ok(())
    }

    /// The variable with only the changed values; with all values if one of them disappears from an array.
    fn finished(mut self) -> SavedData {
        self.touched.sort_unstable();
        self.touched.dedup();
        let base = walk::variable(self.file, &mut self.data).base;
        let initial = self.file.initial_fields(base);
        let mut is_gone = vec![false; self.data.values.len()];
        for at in &self.touched {
            let Some((value, gone)) = self.data.values.get_mut(*at).zip(is_gone.get_mut(*at)) else { continue };
            initial::complete(value, &initial);
            let is_initial =
                matches!(&value.content, SavedContent::Fields(fields) if fields.iter().all(|field| field.initial));
            *gone = is_initial && self.data.shape != SavedContainer::Keys;
        }
        let removes = is_gone.iter().take(self.written).any(|gone| *gone);
        let mut touched = vec![removes; self.data.values.len()];
        self.touched.iter().filter_map(|at| touched.get_mut(*at).map(|touched| *touched = true)).for_each(drop);
        let mut kept = touched.into_iter().zip(is_gone).map(|(touched, gone)| touched && !gone);
        self.data.values.retain(|_| kept.next().unwrap_or(false));
        self.data.is_part = !removes;
        self.data
    }
}

/// Attribute of a value's father.
const FATHER: &str = "fatherId";

/// Normalised key, by which a container's values are found.
fn known_key(shape: &SavedContainer, key: &str) -> String {
    if *shape == SavedContainer::Keys { key.to_owned() } else { key_of(key) }
}

/// Sets a cell in a value with this type, or in a field inside it.
fn nested(
    file: &DataFile<'_>,
    mut base: Base,
    mut type_name: SmolStr,
    value: &mut SavedValue,
    cell: &CellEdit,
) -> Result<(), DataProblem> {
    let mut value = value;
    for step in &cell.place.within {
        let found = walk::field_of(file, base, value, step)?;
        (base, type_name) = (found.base, found.data.type_name.clone());
        let at = walk::position(found.data, &step.key);
        value = walk::value(file, found, &step.key, at)?;
    }
    check_column(file, &type_name, cell)?;
    let SavedContent::Attributes(known) = &value.content else {
        return Err(refusal(format!("a value of `{type_name}` has fields, and no column `{}`", cell.column)));
    };
    let old = known.iter().find(|(name, _)| *name == cell.column).map(|(_, text)| text.as_str());
    if file.dialect == Dialect::Old && old.is_none() {
        return Err(refusal(format!("the file does not write `{}` of `{}`", cell.column, cell.place.name)));
    }
    if !same_text(&type_name, &cell.column, old, cell.text.as_deref()) {
        let none = cell.text.is_none() && file.dialect == Dialect::Old && is_reference(&type_name, &cell.column);
        set_text(value, &cell.column, if none { Some("") } else { cell.text.as_deref() });
    }
    Ok(())
}

/// Checks that the type has the column, and that the file can represent the text.
fn check_column(file: &DataFile<'_>, type_name: &str, cell: &CellEdit) -> Result<(), DataProblem> {
    let column = &cell.column;
    let Some((ty, arm)) = BaseType::from_file_name(type_name) else {
        return Err(refusal(format!("a value of `{type_name}` has fields, and no column `{column}`")));
    };
    let is_old = file.dialect == Dialect::Old;
    if is_old && ty.is_linkable() {
        return Err(refusal(format!("files of s5 and s6 write no links: a program links `{}`", cell.place.name)));
    }
    if attribute(ty, arm.or(file.items.arm.filter(|_| !is_old)), column).is_none() {
        return Err(refusal(format!("a value of `{type_name}` has no column `{column}`")));
    }
    let text = cell.text.as_deref().unwrap_or("");
    if is_old && is_reference(type_name, column) && !is_old_reference(text) {
        return Err(refusal(format!("`{text}` is no data with an index, such as `fTable[0]` or `io:valve1[0]`")));
    }
    Ok(())
}

/// Whether the column references other data in files of s5 and s6.
fn is_reference(type_name: &str, column: &str) -> bool {
    let known = BaseType::from_file_name(type_name).and_then(|(ty, arm)| attribute(ty, arm, column));
    known.is_some_and(|known| matches!(known.value, AttributeValue::Father(_) | AttributeValue::Link))
}

fn set_text(value: &mut SavedValue, column: &str, text: Option<&str>) {
    let SavedContent::Attributes(known) = &mut value.content else { return };
    let at = known.iter().position(|(name, _)| name == column);
    match (at.and_then(|at| known.get_mut(at)), text) {
        (Some((_, old)), Some(text)) => text.clone_into(old),
        (None, Some(text)) => known.push((column.into(), text.to_owned())),
        (_, None) => known.retain(|(name, _)| name != column),
    }
}
