//! Variables of stack frames and selected data as a new data file, for clients outside.

use std::collections::BTreeMap;
use std::error::Error;
use std::fmt;

use val3_bytecode::{DataDef, FrameVariable, Storage};
use val3_data::{DeclaredData, SavedContainer, SavedData, SavedValue, document};
use val3_lang::fault::{Fault, Result as FaultResult};
use val3_lang::memory::{Memory, Place, StoreId, ValueType, View};
use val3_vm::{Frame, InstanceId};

use super::Saving;
use super::values::{LoadedValue, Saver, keys, saved_shape, type_name};

/// Index of the only value of a variable.
const FIRST: &str = "0";

/// Selected global data.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct DataSelection {
    /// Application or library in memory.
    pub instance: InstanceId,
    /// Name of the data.
    pub name: String,
    /// Index or key of one value as written in files: `3`, `1,2`, `home`; `None` for all values.
    pub index: Option<String>,
}

/// Reason why values cannot be written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum DocumentFault {
    /// There is no such task or stack frame.
    NoFrame,
    /// The application or library has no data with this name.
    NoData(String),
    /// The data has no value with this index or key.
    NoElement {
        /// Name of the data.
        name: String,
        /// Index or key.
        index: String,
    },
    /// The values are larger than `libSave` would write.
    TooLarge,
    /// A value was removed from memory.
    Removed,
}

impl fmt::Display for DocumentFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoFrame => f.write_str("the task has no such stack frame"),
            Self::NoData(name) => write!(f, "the application has no data `{name}`"),
            Self::NoElement { name, index } => write!(f, "`{name}` has no value with the index `{index}`"),
            Self::TooLarge => f.write_str("the values exceed the limit of libSave: request fewer values"),
            Self::Removed => f.write_str("a value is no longer in memory"),
        }
    }
}

impl Error for DocumentFault {}

/// Location of a variable's values.
#[derive(Debug, Clone, Copy)]
enum VariablePlace {
    /// One value.
    Single(Place),
    /// An array or collection.
    Container(View),
}

/// Parameters and locals of a stack frame in a program of the saved instance. The memory has to contain the stack.
pub(in crate::devices) fn frame_document(saving: &Saving<'_>, frame: &Frame) -> Result<String, DocumentFault> {
    let saver = saving.saver().ok_or(DocumentFault::NoFrame)?;
    let program = saver.instance.image.programs.get(usize::from(frame.program)).ok_or(DocumentFault::NoFrame)?;
    let mut left = saving.limit;
    let mut all = Vec::new();
    for variable in &program.variables {
        let place = place(saver.memory, frame, variable.storage).ok_or(DocumentFault::Removed)?;
        if let VariablePlace::Container(View { store, .. }) = place {
            left = left.checked_sub(saver.memory.bytes(store)).ok_or(DocumentFault::TooLarge)?;
        }
        let data = saver.variable(variable, place).map_err(|_| DocumentFault::Removed)?;
        all.push(DeclaredData { is_public: false, data });
    }
    Ok(document(&all))
}

/// Selected data of several instances, in the order of the selections.
pub(in crate::devices) fn data_document<'s>(
    selections: &[DataSelection],
    saving: impl Fn(InstanceId) -> Saving<'s>,
) -> Result<String, DocumentFault> {
    let mut savers: BTreeMap<InstanceId, Option<Saver<'s>>> = BTreeMap::new();
    let mut left = None;
    let mut all = Vec::new();
    for selection in selections {
        let saving = saving(selection.instance);
        let saver = savers.entry(selection.instance).or_insert_with(|| saving.saver());
        let saver = saver.as_ref().ok_or_else(|| DocumentFault::NoData(selection.name.clone()))?;
        all.push(saver.selected(selection, left.get_or_insert(saving.limit))?);
    }
    Ok(document(&all))
}

impl Saver<'_> {
    /// Returns selected data. Subtracts the size of containers from the remaining size in bytes.
    fn selected(&self, selection: &DataSelection, left: &mut u64) -> Result<DeclaredData, DocumentFault> {
        let DataSelection { name, index, .. } = selection;
        let no_data = || DocumentFault::NoData(name.clone());
        let number = self.instance.image.data(name).ok_or_else(no_data)?;
        let data = self.instance.image.data.get(usize::from(number)).ok_or_else(no_data)?;
        let store = *self.instance.data.get(usize::from(number)).ok_or_else(no_data)?;
        let saved = match index {
            None => {
                *left = left.checked_sub(self.memory.bytes(store)).ok_or(DocumentFault::TooLarge)?;
                self.data(data, store, number.into()).map_err(|_| DocumentFault::Removed)?
            }
            Some(index) => {
                let element = self.memory.store(store).ok().and_then(|found| found.number_of_text(index));
                let no_element = || DocumentFault::NoElement { name: name.clone(), index: index.clone() };
                let element = element.ok_or_else(no_element)?;
                self.element(data, number.into(), store, element).map_err(|_| no_element())?
            }
        };
        Ok(DeclaredData { is_public: data.public, data: saved })
    }

    /// Returns one value of global data, with the sizes of its array.
    fn element(&self, data: &DataDef, number: u32, id: StoreId, element: u32) -> FaultResult<SavedData> {
        let store = self.memory.store(id)?;
        let place = self.memory.element(View::whole(id), element)?;
        let key = keys(&store.shape).into_iter().find(|(known, _)| *known == element);
        let key = key.map(|(_, key)| key).ok_or(Fault::INDEX_TOO_LARGE)?;
        let (content, _) = self.content(place, &store.kind, &LoadedValue::of_data(data, number), &key)?;
        let (shape, values) = (saved_shape(&store.shape), vec![SavedValue { key, content }]);
        let (name, type_name) = (data.name.as_str().into(), type_name(&store.kind).into());
        Ok(SavedData { name, type_name, shape, values, is_part: true })
    }

    /// Returns a parameter or local.
    fn variable(&self, variable: &FrameVariable, place: VariablePlace) -> FaultResult<SavedData> {
        let name = &variable.name;
        match place {
            VariablePlace::Single(place) => {
                let (content, _) = self.content(place, &variable.kind, &LoadedValue::NONE, FIRST)?;
                Ok(array(name, &variable.kind, vec![SavedValue { key: FIRST.to_owned(), content }], 1))
            }
            VariablePlace::Container(view) if view.start == 0 => {
                self.container(name, view.store, &LoadedValue::NONE).map(|(saved, _)| saved)
            }
            VariablePlace::Container(view) => self.rest(name, view),
        }
    }

    /// Returns an array by reference from an index on.
    fn rest(&self, name: &str, view: View) -> FaultResult<SavedData> {
        let (store, size) = (self.memory.store(view.store)?, self.memory.len(view)?);
        let mut values = Vec::new();
        for index in 0..size {
            let (place, key) = (self.memory.element(view, index)?, index.to_string());
            let (content, _) = self.content(place, &store.kind, &LoadedValue::NONE, &key)?;
            values.push(SavedValue { key, content });
        }
        Ok(array(name, &store.kind, values, size))
    }
}

/// Returns the location of a variable; `None` if the stack does not contain it.
fn place(memory: &Memory, frame: &Frame, storage: Storage) -> Option<VariablePlace> {
    let (base, stack) = (&frame.base, &memory.stack);
    let at = |first: u32, number: u16| first as usize + usize::from(number);
    Some(match storage {
        Storage::Value(lanes) => VariablePlace::Single(frame.place(lanes)),
        Storage::Place(number) => VariablePlace::Single(*stack.places.get(at(base.place, number))?),
        Storage::Part(number) => VariablePlace::Container(View::whole(*stack.parts.get(at(base.part, number))?)),
        Storage::View(number) => VariablePlace::Container(*stack.views.get(at(base.view, number))?),
    })
}

/// Returns a variable with a one-dimensional array of this size.
fn array(name: &str, kind: &ValueType, values: Vec<SavedValue>, size: u32) -> SavedData {
    let shape = SavedContainer::Sizes(vec![size]);
    SavedData { name: name.into(), type_name: type_name(kind).into(), shape, values, is_part: false }
}
