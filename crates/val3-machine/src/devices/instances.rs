//! What is in memory, as far as the record of a run names it.

use std::sync::Arc;

use val3_bytecode::{DataDef, Image, Program};
use val3_lang::memory::{Place, Shape, StoreId};
use val3_lang::ports::CodePlace;

use super::Devices;

/// An application or library in memory.
pub(super) struct Held {
    image: Arc<Image>,
    data: Arc<[StoreId]>,
}

impl Devices {
    /// An application or library has come into memory under a number.
    pub(super) fn hold(&mut self, instance: u16, image: &Arc<Image>, data: &Arc<[StoreId]>) {
        let at = usize::from(instance);
        if self.instances.len() <= at {
            self.instances.resize_with(at + 1, || None);
        }
        if let Some(slot) = self.instances.get_mut(at) {
            *slot = Some(Held { image: Arc::clone(image), data: Arc::clone(data) });
        }
    }

    /// The program, the line of the file and the file of a place.
    pub(crate) fn place(&self, at: CodePlace) -> (String, u32, String) {
        let held = self.instances.get(usize::from(at.instance)).and_then(Option::as_ref);
        let found = held.and_then(|Held { image, .. }| {
            let program: &Program = image.programs.get(usize::from(at.program))?;
            let line = program.line_of(at.line).and_then(|number| program.lines.get(number));
            let file = image.files.get(program.file as usize).cloned().unwrap_or_default();
            Some((program.name.clone(), line.map_or(0, |line| line.row), file))
        });
        found.unwrap_or_default()
    }
}

impl Held {
    /// The global `screen` variable at a place, with its index or key if it has several values.
    pub(super) fn name_of(&self, screen: Place) -> Option<String> {
        let number = self.data.iter().position(|store| *store == screen.store)?;
        self.image.data.get(number).map(|data| named(data, screen.link))
    }
}

fn named(data: &DataDef, number: u32) -> String {
    let name = &data.name;
    match &data.init.shape {
        Shape::Array { dims, sizes } if data.init.shape.len() > 1 => {
            let [_, rows, columns] = *sizes;
            let indexes = [number / (rows * columns), number / columns % rows, number % columns];
            let indexes: Vec<String> = indexes.iter().take(usize::from(*dims)).map(u32::to_string).collect();
            format!("{name}[{}]", indexes.join(","))
        }
        Shape::Array { .. } if number == 0 => name.clone(),
        Shape::Array { .. } => format!("{name}[{number}]"),
        Shape::Collection(keys) => {
            let key = keys.iter().find(|(_, at)| **at == number).map(|(key, _)| key);
            key.map_or_else(|| name.clone(), |key| format!("{name}[\"{key}\"]"))
        }
    }
}
