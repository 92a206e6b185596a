//! The services of the controller for the run time, in addition to the ports of instructions.

use std::sync::Arc;

use val3_bytecode::Image;
use val3_lang::memory::StoreId;
use val3_lang::ports::{Ports, Time};

use crate::{InstanceId, Space};

/// The controller around the run time.
pub trait Host: Ports {
    /// The time that the last instruction has taken outside the program, such as on a medium; 0 when asked again.
    fn take_elapsed(&mut self) -> Time;

    /// Whether the cycle has to stop after the current instruction: the run is to end, or the caller has to take the
    /// recorded events first. The cycle resumes with the next call.
    fn is_interrupted(&self) -> bool;

    /// The task that runs is at an instruction that this controller does not have.
    fn lacking(&mut self, instruction: &str);

    /// An application or library has come into memory under a number, with its global data; events refer to it.
    fn loaded(&mut self, instance: u16, image: &Arc<Image>, data: &Arc<[StoreId]>);

    /// Reports that a library was loaded or saved under an identifier, or the error code. `path` is as the program gave
    /// it; without an identifier the application itself is meant.
    fn library(&mut self, done: LibraryOp, alias: &str, path: &str, code: u16);

    /// There is no memory left for the library at this path.
    fn no_memory_for(&mut self, path: &str);

    /// Compiles the library that a program names (6.6).
    ///
    /// `from` is the path of the application or library whose program asks.
    ///
    /// # Errors
    /// The code of `libLoad`.
    fn load(&mut self, from: &str, library: LibraryRequest<'_>) -> Result<LoadedLibrary, u16>;

    /// Saves data and programs of an application or library; the code of `libSave` (6.6).
    ///
    /// `to` is the path that the program, which is one of `from`, gives. Without one, the files that `saved` was loaded
    /// from are replaced.
    fn save(&mut self, space: &Space, from: InstanceId, saved: InstanceId, to: Option<&str>) -> u16;
}

/// An operation on a library.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LibraryOp {
    /// It was loaded.
    Load,
    /// It was saved.
    Save,
}

/// A library as a program or a declaration asks for it.
#[derive(Debug, Clone, Copy)]
pub struct LibraryRequest<'r> {
    /// The identifier that it is loaded under.
    pub alias: &'r str,
    /// Its path.
    pub path: &'r str,
    /// The password of an encrypted one, otherwise empty.
    pub password: &'r str,
}

/// A library that was found.
#[derive(Debug, Clone)]
pub struct LoadedLibrary {
    /// Its image.
    pub image: Arc<Image>,
    /// Its full path: libraries with one path are one library in memory.
    pub path: String,
}
