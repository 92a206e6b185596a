//! Services of the controller for the virtual machine, in addition to the ports of instructions.

use std::sync::Arc;

use val3_bytecode::Image;
use val3_lang::memory::StoreId;
use val3_lang::ports::{Ports, Time};

use crate::{InstanceId, Space};

/// The controller that contains the virtual machine.
pub trait Host: Ports {
    /// Returns the time that the last instruction used outside the program, for example on a medium, and resets it to
    /// 0.
    fn take_elapsed(&mut self) -> Time;

    /// Whether the cycle has to stop after the current instruction because the run should end or the caller has to read
    /// the recorded events first. The next call resumes the cycle.
    fn is_interrupted(&self) -> bool;

    /// Reports that the running task has reached an instruction that this controller does not support.
    fn lacking(&mut self, instruction: &str);

    /// Reports that an application or library was loaded under a number, with its global data. Events refer to this
    /// number.
    fn loaded(&mut self, instance: u16, image: &Arc<Image>, data: &Arc<[StoreId]>);

    /// Reports that a library was loaded or saved under an identifier, or the error code. `path` is the path in the
    /// program; an empty identifier means the application itself.
    fn library(&mut self, done: LibraryOp, alias: &str, path: &str, code: u16);

    /// Reports that the memory does not suffice for the library at this path.
    fn no_memory_for(&mut self, path: &str);

    /// Compiles the library that a program loads (6.6).
    ///
    /// `from` is the path of the application or library that contains the program.
    ///
    /// # Errors
    /// The result code of `libLoad`.
    fn load(&mut self, from: &str, library: LibraryRequest<'_>) -> Result<LoadedLibrary, u16>;

    /// Saves data and programs of the application or library `saved`, and returns the result code of `libSave` (6.6).
    ///
    /// `to` is the path in the program, which belongs to `from`. Without a path, the files from which `saved` was
    /// loaded are replaced.
    fn save(&mut self, space: &Space, from: InstanceId, saved: InstanceId, to: Option<&str>) -> u16;
}

/// Operation on a library.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LibraryOp {
    /// The library was loaded.
    Load,
    /// The library was saved.
    Save,
}

/// A library as a program or a declaration requests it.
#[derive(Debug, Clone, Copy)]
pub struct LibraryRequest<'r> {
    /// Identifier under which it is loaded.
    pub alias: &'r str,
    /// Path.
    pub path: &'r str,
    /// Password for an encrypted library, otherwise empty.
    pub password: &'r str,
}

/// A compiled library.
#[derive(Debug, Clone)]
pub struct LoadedLibrary {
    /// Image.
    pub image: Arc<Image>,
    /// Full path. Libraries with the same path are one library in memory.
    pub path: String,
}
