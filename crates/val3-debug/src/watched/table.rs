//! Elements of arrays and collections, for tables.

use std::ops::Range;

use val3_machine::controller::Controller;

use super::numbers::{DataForm, numbers_of, series_of};
use super::{ValueLocation, WatchedData};
use crate::values;

/// Elements of an array or collection.
#[derive(Debug, Clone, PartialEq)]
pub struct DataTable {
    /// Type of the array or collection, and the numbers in each element.
    pub form: DataForm,
    /// Number of elements.
    pub count: usize,
    /// Requested elements.
    pub rows: Vec<TableRow>,
}

/// Element of an array or collection.
#[derive(Debug, Clone, PartialEq)]
pub struct TableRow {
    /// Index or key, for example `[1,0]` or `["left"]`.
    pub index: String,
    /// Value.
    pub value: String,
    /// Numbers of the value, in the order of [`DataForm::series`]. A number is `None` if it is not finite, or if the
    /// signal of an input or output cannot be read.
    pub numbers: Vec<Option<f64>>,
}

impl WatchedData {
    /// Returns a range of the present elements; `None` if the data are no array or collection, or not in memory.
    pub fn table(&self, controller: &mut Controller, range: Range<usize>) -> Option<DataTable> {
        let length_unit = controller.length_unit();
        self.look(controller, |memory, devices, found| {
            let ValueLocation::All(view) = found else { return None };
            let (kind, count) = (&memory.store(view.store).ok()?.kind, memory.len(view).ok()? as usize);
            let range = range.start.min(count)..range.end.min(count);
            let rows = values::element_places(memory, view, range).into_iter().map(|(index, place)| TableRow {
                index,
                value: values::text_of(memory, devices, kind, place, values::DisplayFormat::EXACT),
                numbers: numbers_of(memory, devices, kind, place),
            });
            let type_name = values::type_of_all(memory, view)?;
            let form = DataForm { type_name, length_unit, series: series_of(kind) };
            Some(DataTable { form, count, rows: rows.collect() })
        })
    }
}
