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
    /// Fragments on the stacks of tasks, by their distance from the program number [`FRAGMENT`]. `None` for a free number.
    pub(crate) fragments: Vec<Option<Arc<Program>>>,
    /// Number of the image's first counter among the counters of all images.
    pub(crate) first_counter: u32,
    /// Whether it is loaded. After unloading, the number is free.
    pub loaded: bool,
}

/// Program number of the first fragment. The next fragments have the numbers below it; images have fewer programs.
const FRAGMENT: u16 = u16::MAX;

impl Instance {
    /// Returns a program of the image, or a fragment on the stack of a task.
    #[must_use]
    pub fn program(&self, number: u16) -> Option<&Program> {
        self.image.programs.get(usize::from(number)).or_else(|| self.fragment(number).ok())
    }

    /// Whether a program number denotes a fragment.
    #[must_use]
    pub fn is_fragment(&self, number: u16) -> bool {
        self.fragment(number).is_ok()
    }

    /// Returns a fragment.
    #[cold]
    pub(crate) fn fragment(&self, number: u16) -> Result<&Program> {
        let fragment = self.fragments.get(usize::from(FRAGMENT - number)).and_then(Option::as_deref);
        fragment.ok_or(Fault::INTERPRETER)
    }

    /// Adds a fragment, and returns its program number. Returns `None` without a free number.
    pub(crate) fn add_fragment(&mut self, program: &Arc<Program>) -> Option<u16> {
        let free = self.fragments.iter().position(Option::is_none).unwrap_or(self.fragments.len());
        let number = FRAGMENT.checked_sub(u16::try_from(free).ok()?)?;
        if usize::from(number) < self.image.programs.len() {
            return None;
        }
        self.fragments.resize(self.fragments.len().max(free + 1), None);
        if let Some(slot) = self.fragments.get_mut(free) {
            *slot = Some(Arc::clone(program));
        }
        Some(number)
    }

    /// Removes the fragments that do not satisfy a predicate of their program numbers.
    pub(crate) fn retain_fragments(&mut self, is_used: impl Fn(u16) -> bool) {
        for (number, slot) in (0..=FRAGMENT).rev().zip(&mut self.fragments) {
            if !is_used(number) {
                *slot = None;
            }
        }
        self.fragments.truncate(self.fragments.iter().rposition(Option::is_some).map_or(0, |last| last + 1));
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
