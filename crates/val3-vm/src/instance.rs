//! Images in memory: applications and libraries with their data (6.6).

use std::sync::Arc;

use val3_bytecode::{Image, Program};
use val3_lang::fault::{Fault, Result};
use val3_lang::memory::StoreId;

/// Number that identifies an application or library in memory.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct InstanceId(pub u16);

/// An application or library in memory.
#[derive(Debug, Clone)]
pub struct Instance {
    /// Image.
    pub image: Arc<Image>,
    /// Path from which it was loaded, as the program wrote it.
    pub path: String,
    /// Global data.
    pub data: Arc<[StoreId]>,
    /// Libraries that its identifiers currently denote.
    pub libraries: Vec<Option<InstanceId>>,
    /// Imported items of these libraries; `None` if a library is not loaded or does not contain the item (error 80).
    pub imports: Vec<Option<Imported>>,
    /// Code that is executed in a program's stack frame, under the program number [`FRAGMENT`].
    pub(crate) fragment: Option<Arc<Program>>,
    /// Number of the image's first counter among the counters of all images.
    pub(crate) first_counter: u32,
    /// Whether it is loaded. After unloading, the number is free.
    pub loaded: bool,
}

/// Program number of the executed fragment. Images have fewer programs.
pub(crate) const FRAGMENT: u16 = u16::MAX;

impl Instance {
    /// Returns the executed fragment.
    #[cold]
    pub(crate) fn fragment(&self, number: u16) -> Result<&Program> {
        self.fragment.as_deref().filter(|_| number == FRAGMENT).ok_or(Fault::INTERPRETER)
    }
}

/// A program of an application or library in memory.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ProgramId {
    /// Application or library.
    pub instance: InstanceId,
    /// Number of the program in its image.
    pub number: u16,
}

/// Imported item of a library.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Imported {
    /// Data.
    Data(StoreId),
    /// Program.
    Program(ProgramId),
}
