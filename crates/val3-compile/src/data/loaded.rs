//! Values at the start with the links that are made when all data exist.

use val3_bytecode::LinkTarget;
use val3_lang::memory::PartInit;

/// A container with its values, and the links of these values.
pub(crate) struct Loaded {
    pub(crate) init: PartInit,
    pub(crate) links: Vec<Found>,
}

/// The link of a value of a container, or of a value within one.
#[derive(Debug, Clone)]
pub(crate) struct Found {
    /// Number of a value, then of its field, from the container inwards.
    pub(crate) path: Vec<(u32, u32)>,
    /// The number of the value in the innermost container.
    pub(crate) value: u32,
    /// The number of the link among those of the value.
    pub(crate) link: u32,
    pub(crate) target: LinkTarget,
}

impl Found {
    /// The same link, as seen from the container around.
    pub(crate) fn within(&self, value: u32, field: u32) -> Self {
        let path = std::iter::once((value, field)).chain(self.path.iter().copied()).collect();
        Self { path, ..self.clone() }
    }
}
