//! Initial values, with the links that are set after all data exist.

use val3_bytecode::LinkTarget;
use val3_lang::memory::PartInit;

/// A container with its values, and their links.
pub(crate) struct Loaded {
    pub(crate) init: PartInit,
    pub(crate) links: Vec<LoadedLink>,
}

/// Link in a container's value, or in a value nested in it.
#[derive(Debug, Clone)]
pub(crate) struct LoadedLink {
    /// Path from the outermost container: for each level, the value number and the field number.
    pub(crate) path: Vec<(u32, u32)>,
    /// Number of the value in the innermost container.
    pub(crate) value: u32,
    /// Number of the link within the value.
    pub(crate) link: u32,
    pub(crate) target: LinkTarget,
}

impl LoadedLink {
    /// Returns the link as a part of the enclosing container.
    pub(crate) fn within(&self, value: u32, field: u32) -> Self {
        let path = std::iter::once((value, field)).chain(self.path.iter().copied()).collect();
        Self { path, ..self.clone() }
    }
}
