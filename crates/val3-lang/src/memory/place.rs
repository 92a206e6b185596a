//! Where a value is.

use super::Lanes;
use crate::fault::{Fault, Result};

/// A container of the memory. One that was removed has no successor under the same name.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct StoreId {
    pub(super) index: u32,
    pub(super) generation: u32,
}

impl StoreId {
    /// The stack of the task that runs.
    pub const STACK: Self = Self { index: u32::MAX, generation: 0 };
}

/// Where the lanes of a value begin: an element by reference (2.6.2).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Place {
    /// The container, or the stack.
    pub store: StoreId,
    /// The first of its numbers.
    pub num: u32,
    /// The first of its texts.
    pub text: u32,
    /// The first of its links.
    pub link: u32,
    /// The first of its containers.
    pub part: u32,
}

impl Place {
    /// The place in a container whose lanes begin at `lanes`.
    #[must_use]
    pub const fn new(store: StoreId, lanes: Lanes) -> Self {
        Self { store, num: lanes.num, text: lanes.text, link: lanes.link, part: lanes.part }
    }

    /// A place on the stack of the task that runs.
    #[must_use]
    pub const fn on_stack(lanes: Lanes) -> Self {
        Self::new(StoreId::STACK, lanes)
    }

    /// The first value of a container.
    #[must_use]
    pub const fn first(store: StoreId) -> Self {
        Self::new(store, Lanes::nums(0))
    }

    /// The place `lanes` after this one: a field.
    #[must_use]
    pub fn after(self, lanes: Lanes) -> Self {
        Self::new(self.store, Lanes { num: self.num, text: self.text, link: self.link, part: self.part } + lanes)
    }
}

/// A container by reference, a one-dimensional array from an index on (2.6.3).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct View {
    /// The container.
    pub store: StoreId,
    /// The first value that can be reached.
    pub start: u32,
}

impl View {
    /// The whole of a container.
    #[must_use]
    pub const fn whole(store: StoreId) -> Self {
        Self { store, start: 0 }
    }
}

/// A value of a container that need not exist: `insert(x[3])`, `isDefined(x["k"])`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Slot {
    /// The container; `None` where a library lacks it.
    pub view: Option<View>,
    /// Which of its values.
    pub at: Subscript<f64, Place>,
}

impl Slot {
    /// The container.
    ///
    /// # Errors
    /// 80 where a library lacks it.
    pub fn container(&self) -> Result<View> {
        self.view.ok_or(Fault::LIBRARY_ITEM_MISSING)
    }
}

/// Which value of a container is meant. Indexes and keys are values at run time and registers in the code.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Subscript<I, K> {
    /// The variable has no subscript: its first value, or all of them.
    Whole,
    /// One index.
    One(I),
    /// Two indexes.
    Two([I; 2]),
    /// Three indexes.
    Three([I; 3]),
    /// A key.
    Key(K),
}

/// The target of a value's link.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Link {
    /// Nothing.
    #[default]
    None,
    /// Its reference frame or tool (9.4 to 9.6).
    Data(Place),
    /// An input, output or serial line of the controller (3.5 to 3.7), or a screen (4.2), by its number there.
    Port(u32),
}
