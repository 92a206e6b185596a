//! An image in memory: the data of an application or library (6.6).

use std::sync::Arc;

use val3_bytecode::Image;
use val3_lang::memory::StoreId;

/// An application or library in memory.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct InstanceId(pub u16);

/// An application or library in memory.
#[derive(Debug, Clone)]
pub struct Instance {
    /// Its image.
    pub image: Arc<Image>,
    /// The path it was loaded from, as the program wrote it.
    pub path: String,
    /// Its global data.
    pub data: Arc<[StoreId]>,
    /// The libraries that its identifiers currently denote.
    pub libraries: Vec<Option<InstanceId>>,
    /// The items that it uses of them; `None` where a library is not loaded or lacks the item (error 80).
    pub imports: Vec<Option<Imported>>,
    /// Whether it is loaded. The number of an unloaded instance is free.
    pub loaded: bool,
}

/// An item of a library.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Imported {
    /// Data.
    Data(StoreId),
    /// A program.
    Program(InstanceId, u16),
}
