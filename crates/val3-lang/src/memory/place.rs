//! Addresses of values.

use super::Lanes;
use crate::fault::{Fault, Result};

/// Identity of a container in memory. It is not reused after the container was removed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct StoreId {
    pub(super) index: u32,
    pub(super) generation: u32,
}

impl StoreId {
    /// The stack of the running task.
    pub const STACK: Self = Self { index: u32::MAX, generation: 0 };
}

/// Address of a value's lanes: an element by reference (2.6.2).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Place {
    /// Container, or the stack.
    pub store: StoreId,
    /// Layout of the container for which the lanes below were computed.
    pub(super) layout: u32,
    /// Index of the first number.
    pub num: u32,
    /// Index of the first string.
    pub text: u32,
    /// Index of the first link.
    pub link: u32,
    /// Index of the first inner container.
    pub part: u32,
}

impl Place {
    /// Address of the value whose lanes begin at `lanes` in a container's first layout. For elements of containers, use
    /// [`Store::place`](super::Store::place).
    #[must_use]
    const fn new(store: StoreId, lanes: Lanes) -> Self {
        Self::in_layout(store, store.generation, lanes)
    }

    /// Address of the value whose lanes begin at `lanes` in a container with this layout.
    pub(super) const fn in_layout(store: StoreId, layout: u32, lanes: Lanes) -> Self {
        Self { store, layout, num: lanes.num, text: lanes.text, link: lanes.link, part: lanes.part }
    }

    /// Lanes at which the value begins.
    #[must_use]
    pub const fn lanes(self) -> Lanes {
        Lanes { num: self.num, text: self.text, link: self.link, part: self.part }
    }

    /// Address on the stack of the running task.
    #[must_use]
    pub const fn on_stack(lanes: Lanes) -> Self {
        Self::new(StoreId::STACK, lanes)
    }

    /// Address of a container's first value.
    #[must_use]
    pub const fn first(store: StoreId) -> Self {
        Self::new(store, Lanes::nums(0))
    }

    /// Address `lanes` after this one: a field.
    #[must_use]
    pub fn after(self, lanes: Lanes) -> Self {
        Self::in_layout(self.store, self.layout, self.lanes() + lanes)
    }
}

/// A container by reference, or a one-dimensional array from an index (2.6.3).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct View {
    /// Container.
    pub store: StoreId,
    /// Index of the first accessible element.
    pub start: u32,
}

impl View {
    /// Creates a view of an entire container.
    #[must_use]
    pub const fn whole(store: StoreId) -> Self {
        Self { store, start: 0 }
    }
}

/// An element that need not exist: `insert(x[3])`, `isDefined(x["k"])`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Slot {
    /// Container; `None` if it does not exist in its library.
    pub view: Option<View>,
    /// Index or key of the element.
    pub at: Subscript<f64, Place>,
}

impl Slot {
    /// Returns the container.
    ///
    /// # Errors
    /// 80 if it does not exist in its library.
    pub fn container(&self) -> Result<View> {
        self.view.ok_or(Fault::LIBRARY_ITEM_MISSING)
    }
}

/// Element index or key. At run time it contains values, in the code it contains registers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Subscript<I, K> {
    /// The variable has no subscript, which means its first element or all elements.
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

/// Link target of a value.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum LinkPlace {
    /// No target.
    #[default]
    None,
    /// The father of a frame, tool or point (9.4 to 9.6).
    Data(Place),
    /// An input, output or serial line of the controller (3.5 to 3.7), or a screen (4.2), by its number.
    Port(u32),
}
