//! An image in memory: the data of an application or library (6.6).

use std::sync::Arc;

use val3_bytecode::{Image, Program};
use val3_lang::fault::{Fault, Result};
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
    /// The code that is executed in a frame of a program, with the number [`FRAGMENT`].
    pub(crate) fragment: Option<Arc<Program>>,
    /// The number of its first counter among those of all images.
    pub(crate) first_counter: u32,
    /// Whether it is loaded. The number of an unloaded instance is free.
    pub loaded: bool,
}

/// The number of a fragment that is executed. Images have fewer programs.
pub(crate) const FRAGMENT: u16 = u16::MAX;

impl Instance {
    /// The fragment that is executed.
    #[cold]
    pub(crate) fn fragment(&self, number: u16) -> Result<&Program> {
        self.fragment.as_deref().filter(|_| number == FRAGMENT).ok_or(Fault::INTERPRETER)
    }
}

/// An item of a library.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Imported {
    /// Data.
    Data(StoreId),
    /// A program.
    Program(InstanceId, u16),
}
