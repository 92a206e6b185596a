//! Applications and libraries in memory: their names in the record of a run, and their files.

use std::collections::BTreeMap;
use std::sync::Arc;

use val3_bytecode::{DataDef, Image, Program};
use val3_lang::memory::{ContainerShape, Place, StoreId};
use val3_lang::ports::CodePlace;

use crate::files::LibraryFiles;

/// Applications and libraries in memory.
#[derive(Debug, Clone, Default)]
pub(super) struct LoadedProjects {
    /// By instance number.
    instances: Vec<Option<LoadedInstance>>,
    /// Loaded files by instance number.
    sources: BTreeMap<u16, Arc<LibraryFiles>>,
    /// Replaced lines by instance number.
    replaced: BTreeMap<u16, ReplacedLines>,
    /// The library that was read last, until it is loaded into memory.
    read: Option<(Arc<Image>, Arc<LibraryFiles>)>,
}

/// Replaced lines of an instance: the code, by file and row.
pub type ReplacedLines = BTreeMap<(String, u32), String>;

/// An application or library in memory.
#[derive(Debug, Clone)]
struct LoadedInstance {
    image: Arc<Image>,
    data: Arc<[StoreId]>,
}

impl LoadedProjects {
    /// Stores the files of the next library that will be loaded into memory.
    pub(super) fn keep_read(&mut self, image: &Arc<Image>, files: LibraryFiles) {
        self.read = Some((Arc::clone(image), Arc::new(files)));
    }

    /// Stores the files of the instance.
    pub(super) fn keep_files(&mut self, instance: u16, files: LibraryFiles) {
        self.keep_shared_files(instance, Arc::new(files));
    }

    /// Like [`keep_files`](Self::keep_files), for files of an earlier instance.
    pub(super) fn keep_shared_files(&mut self, instance: u16, files: Arc<LibraryFiles>) {
        self.sources.insert(instance, files);
    }

    /// Returns the loaded files of the instance.
    pub(super) fn files(&self, instance: u16) -> Option<Arc<LibraryFiles>> {
        self.sources.get(&instance).map(Arc::clone)
    }

    /// Returns the replaced lines of the instance.
    pub(super) fn replaced(&self, instance: u16) -> Option<&ReplacedLines> {
        self.replaced.get(&instance)
    }

    /// Stores the replaced lines of an instance.
    pub(super) fn keep_replaced(&mut self, instance: u16, lines: ReplacedLines) {
        self.replaced.insert(instance, lines);
    }

    /// Adds an application or library under its instance number, with its lines as loaded.
    pub(super) fn add(&mut self, instance: u16, image: &Arc<Image>, data: &Arc<[StoreId]>) {
        let at = usize::from(instance);
        if self.instances.len() <= at {
            self.instances.resize_with(at + 1, || None);
        }
        if let Some(slot) = self.instances.get_mut(at) {
            *slot = Some(LoadedInstance { image: Arc::clone(image), data: Arc::clone(data) });
        }
        self.sources.remove(&instance);
        self.replaced.remove(&instance);
        if let Some((_, files)) = self.read.take().filter(|(read, _)| Arc::ptr_eq(read, image)) {
            self.sources.insert(instance, files);
        }
    }

    /// Program, line of the file and file of a code location.
    pub(super) fn position(&self, at: CodePlace) -> (String, u32, String) {
        let instance = self.instances.get(usize::from(at.instance)).and_then(Option::as_ref);
        let found = instance.and_then(|LoadedInstance { image, .. }| {
            let program: &Program = image.programs.get(usize::from(at.program))?;
            let line = program.line_of(at.line).and_then(|number| program.lines.get(number));
            let file = image.files.get(program.file as usize).cloned().unwrap_or_default();
            Some((program.name.clone(), line.map_or(0, |line| line.row), file))
        });
        found.unwrap_or_default()
    }

    /// The name of the global `screen` variable at a place, with its index or key if it has several values.
    pub(super) fn screen(&self, screen: Place) -> Option<String> {
        self.instances.iter().flatten().find_map(|instance| instance.screen(screen))
    }
}

impl LoadedInstance {
    fn screen(&self, screen: Place) -> Option<String> {
        let number = self.data.iter().position(|store| *store == screen.store)?;
        self.image.data.get(number).map(|data| named(data, screen.link))
    }
}

fn named(data: &DataDef, number: u32) -> String {
    let name = &data.name;
    match &data.init.shape {
        ContainerShape::Array { dims, sizes } if data.init.shape.len() > 1 => {
            let [_, rows, columns] = *sizes;
            let indexes = [number / (rows * columns), number / columns % rows, number % columns];
            let indexes: Vec<String> = indexes.iter().take(usize::from(*dims)).map(u32::to_string).collect();
            format!("{name}[{}]", indexes.join(","))
        }
        ContainerShape::Array { .. } if number == 0 => name.clone(),
        ContainerShape::Array { .. } => format!("{name}[{number}]"),
        ContainerShape::Collection(keys) => {
            let key = keys.iter().find(|(_, at)| **at == number).map(|(key, _)| key);
            key.map_or_else(|| name.clone(), |key| format!("{name}[\"{key}\"]"))
        }
    }
}
