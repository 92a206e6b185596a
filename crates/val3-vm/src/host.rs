//! What the run time asks of the controller around it, beside the ports of instructions.

use std::sync::Arc;

use val3_bytecode::{DataDef, Image};
use val3_lang::memory::{Memory, StoreId};
use val3_lang::ports::Ports;

/// The controller around the run time.
pub trait Host: Ports {
    /// An application or library has come into memory under a number, with its global data; events refer to it.
    fn loaded(&mut self, instance: u16, image: &Arc<Image>, data: &Arc<[StoreId]>);

    /// Compiles the library that a program names (6.6).
    ///
    /// `from` is the path of the application or library whose program asks.
    ///
    /// # Errors
    /// The code of `libLoad`.
    fn load(&mut self, from: &str, path: &str, password: &str) -> Result<Loaded, u16>;

    /// Saves data and programs of an application or library; the code of `libSave` (6.6).
    ///
    /// `from` is where it was loaded from, `to` where the program wants it, if it says so.
    fn save(
        &mut self,
        image: &Image,
        memory: &Memory,
        data: &[(&DataDef, StoreId)],
        from: &str,
        to: Option<&str>,
    ) -> u16;
}

/// A library that was found.
#[derive(Debug, Clone)]
pub struct Loaded {
    /// Its image.
    pub image: Arc<Image>,
    /// Its full path: libraries with one path are one library in memory.
    pub path: String,
}
