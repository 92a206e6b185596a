//! The containers that programs name, and where their descriptions are.

use val3_bytecode::{Whole, WholeKind};

use crate::layout::{CONTAINER, CONTAINERS, OWN, SHARED};

/// The containers that all programs of a module share, each with a description of its own.
#[derive(Debug, Default)]
pub(crate) struct Shared(Vec<Whole>);

impl Shared {
    /// Takes a container in if it is shared; whether there is room for its description.
    pub(crate) fn add(&mut self, whole: Whole) -> bool {
        if matches!(whole.kind(), WholeKind::Data(_) | WholeKind::Import(_)) && !self.0.contains(&whole) {
            self.0.push(whole);
        }
        self.0.len() <= CONTAINERS
    }

    /// The containers, each with the address of its description.
    pub(crate) fn iter(&self) -> impl Iterator<Item = (Whole, u32)> + '_ {
        self.0.iter().copied().zip((SHARED..).step_by(CONTAINER as usize))
    }

    /// The address of the description of a container; `None` if it has none.
    pub(crate) fn description(&self, whole: Whole) -> Option<u32> {
        match whole.kind() {
            WholeKind::Part(number) => local(number),
            WholeKind::View(number) => by_reference(number),
            _ => self.iter().find(|(known, _)| *known == whole).map(|(_, address)| address),
        }
    }
}

/// The address of the description of a local container of the frame that was entered.
pub(crate) fn local(number: impl Into<u32>) -> Option<u32> {
    own(number.into() * 2)
}

/// The address of the description of a container by reference of the frame that was entered.
pub(crate) fn by_reference(number: impl Into<u32>) -> Option<u32> {
    own(number.into() * 2 + 1)
}

fn own(number: u32) -> Option<u32> {
    ((number as usize) < CONTAINERS).then_some(OWN + number * CONTAINER)
}
