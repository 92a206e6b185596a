//! Memory limit of declared variables.

use val3_lang::memory::{Lanes, MEMORY, ValueType};
use val3_lang::types::Container;

use super::FileCheck;
use crate::items::data;
use crate::items::project::{Items, resolve_type};
use crate::problem::{DataSize, ProblemKind};
use crate::ty::Base;
use crate::xml::XmlElement;

impl FileCheck<'_> {
    /// Checks the memory of a variable, and its sum with all preceding variables of the file. A variable that exceeds
    /// the limit does not count for the following variables.
    pub(crate) fn memory(&mut self, element: XmlElement<'_>) {
        let Some(name) = element.attribute("name") else { return };
        let bytes = bytes(self.items, element);
        let total = self.bytes.saturating_add(bytes);
        if total <= MEMORY {
            self.bytes = total;
            return;
        }
        let range = element.attribute("size").unwrap_or(name).range;
        self.report(range, ProblemKind::DataTooLarge(DataSize { name: name.text().as_ref().into(), bytes, total }));
    }
}

/// Returns the size of an array's values in bytes. For user types, only the references to the fields are counted, as a
/// lower bound.
fn bytes(items: &Items, element: XmlElement<'_>) -> u64 {
    let Some(declared) = data::declaration(element) else { return 0 };
    if declared.container == Container::Collection {
        return 0;
    }
    let value = match resolve_type(&items.types, &declared.type_name) {
        Some(Base::Builtin(base, arm)) => ValueType::builtin(base, arm).size,
        Some(Base::User(_)) => Lanes { part: 1, ..Lanes::default() },
        Some(Base::Unknown) | None => return 0,
    };
    let count = declared.sizes.iter().fold(1u64, |count, size| count.saturating_mul((*size).into()));
    count.saturating_mul(value.bytes())
}
