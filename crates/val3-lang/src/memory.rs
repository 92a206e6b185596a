//! Data of running programs: containers of values, task stacks, and references between values (2.3 to 2.6).
//!
//! A value is divided into lanes: numbers, truth values and enumerators are in the lane `num`, strings in `text`, and
//! references to other data, inputs, outputs and screens in `link`. A value of a user type has a container for each of
//! its fields in the lane `part`, because the fields of a type are data with containers (7.2). A number therefore
//! always occupies eight bytes, and a point nine numbers and one link.

mod budget;
mod containers;
mod copy;
mod display;
mod kind;
mod lanes;
mod place;
mod reach;
mod rearrange;
mod shape;
mod stack;
mod store;
mod stores;

pub use budget::{MEMORY, MemoryBudget, bytes_of};
pub use kind::{DetachedValue, FieldKind, KindBase, PartInit, ValueType, enumerator, field_offset, path_offset};
pub use lanes::Lanes;
pub use place::{LinkPlace, Place, Slot, StoreId, Subscript, View};
pub use shape::ContainerShape;
pub use stack::Stack;
pub use store::{Owner, Store};
pub use stores::Stores;

use std::sync::Arc;

use crate::fault::{Fault, Result};
use crate::types::BaseType;
use crate::values::Text;

/// All data of a controller, and the stack of the running task.
#[derive(Debug, Clone)]
pub struct Memory {
    /// Containers.
    pub stores: Stores,
    /// Stack of the running task; its [`Place::store`] is [`StoreId::STACK`].
    pub stack: Stack,
    /// Libraries by library identifier, for each application or library that declares identifiers.
    libraries: Vec<Vec<u16>>,
}

impl Memory {
    /// Creates the data that every controller has: `world` and `flange`. Each is its own father, so that a copy has a
    /// father.
    #[must_use]
    pub fn new() -> Self {
        let mut memory = Self { stores: Stores::default(), stack: Stack::default(), libraries: Vec::new() };
        for (index, base) in [(Self::WORLD, BaseType::Frame), (Self::FLANGE, BaseType::Tool)] {
            let mut store = Store::filled(Arc::new(ValueType::builtin(base, None)), ContainerShape::ELEMENT);
            store.links.first_mut().into_iter().for_each(|link| *link = LinkPlace::Data(Place::first(index)));
            // Two small values always fit into the memory.
            let _ = memory.add(store);
        }
        memory
    }

    /// The variable `world` (9.4).
    pub const WORLD: StoreId = StoreId { index: 0, generation: 0 };

    /// The variable `flange` (9.5).
    pub const FLANGE: StoreId = StoreId { index: 1, generation: 0 };

    /// Adds a container, which exists until [`remove`](Self::remove).
    ///
    /// # Errors
    /// 40 without memory.
    pub fn add(&mut self, store: Store) -> Result<StoreId> {
        self.stores.add(store)
    }

    /// Removes a container and its inner containers. References to them cause run-time error 20.
    pub fn remove(&mut self, id: StoreId) {
        self.stores.remove(id);
    }

    /// Returns a container.
    ///
    /// # Errors
    /// 20 if it does not exist.
    #[inline]
    pub fn store(&self, id: StoreId) -> Result<&Store> {
        self.stores.get(id)
    }

    /// As [`store`](Self::store), mutable.
    ///
    /// # Errors
    /// 20 if it does not exist.
    #[inline]
    pub fn store_mut(&mut self, id: StoreId) -> Result<&mut Store> {
        self.stores.get_mut(id)
    }

    /// Size of a container and its inner containers, in bytes.
    #[must_use]
    pub fn bytes(&self, id: StoreId) -> u64 {
        let Ok(store) = self.store(id) else { return 0 };
        store.parts.iter().fold(store.bytes(), |sum, part| sum + self.bytes(*part))
    }

    /// Returns a number, truth value (0 or 1) or enumerator (its index in its type), `offset` lanes after `at`.
    ///
    /// # Errors
    /// 20 if the value does not exist.
    #[inline]
    pub fn num(&self, at: Place, offset: u32) -> Result<f64> {
        let index = (at.num + offset) as usize;
        let found = match at.store {
            StoreId::STACK => self.stack.nums.get(index),
            id => self.store(id)?.nums.get(index),
        };
        found.copied().ok_or(Fault::INDEX_TOO_LARGE)
    }

    /// Writes a value that [`num`](Self::num) reads.
    ///
    /// # Errors
    /// 20 if the value does not exist.
    #[inline]
    pub fn set_num(&mut self, at: Place, offset: u32, value: f64) -> Result<()> {
        let index = (at.num + offset) as usize;
        let found = match at.store {
            StoreId::STACK => self.stack.nums.get_mut(index),
            id => self.store_mut(id)?.nums.get_mut(index),
        };
        *found.ok_or(Fault::INDEX_TOO_LARGE)? = value;
        Ok(())
    }

    /// Reads `N` numbers, for example a transformation or a joint position.
    ///
    /// # Errors
    /// 20 if the value does not exist.
    #[inline]
    pub fn nums<const N: usize>(&self, at: Place, offset: u32) -> Result<[f64; N]> {
        let index = (at.num + offset) as usize;
        let nums = match at.store {
            StoreId::STACK => &self.stack.nums,
            id => &self.store(id)?.nums,
        };
        nums.get(index..).and_then(|rest| rest.first_chunk()).copied().ok_or(Fault::INDEX_TOO_LARGE)
    }

    /// Writes `N` numbers.
    ///
    /// # Errors
    /// 20 if the value does not exist.
    #[inline]
    pub fn set_nums<const N: usize>(&mut self, at: Place, offset: u32, values: [f64; N]) -> Result<()> {
        let index = (at.num + offset) as usize;
        let nums = match at.store {
            StoreId::STACK => &mut self.stack.nums,
            id => &mut self.store_mut(id)?.nums,
        };
        let found = nums.get_mut(index..).and_then(|rest| rest.first_chunk_mut());
        *found.ok_or(Fault::INDEX_TOO_LARGE)? = values;
        Ok(())
    }

    /// Returns a string.
    ///
    /// # Errors
    /// 20 if the value does not exist.
    #[inline]
    pub fn text(&self, at: Place) -> Result<&Text> {
        let found = match at.store {
            StoreId::STACK => self.stack.texts.get(at.text as usize),
            id => self.store(id)?.texts.get(at.text as usize),
        };
        found.ok_or(Fault::INDEX_TOO_LARGE)
    }

    /// Returns a string for writing.
    ///
    /// # Errors
    /// 20 if the value does not exist.
    #[inline]
    pub fn text_mut(&mut self, at: Place) -> Result<&mut Text> {
        let found = match at.store {
            StoreId::STACK => self.stack.texts.get_mut(at.text as usize),
            id => self.store_mut(id)?.texts.get_mut(at.text as usize),
        };
        found.ok_or(Fault::INDEX_TOO_LARGE)
    }

    /// Writes a string.
    ///
    /// # Errors
    /// 20 if the value does not exist.
    #[inline]
    pub fn set_text(&mut self, at: Place, value: Text) -> Result<()> {
        *self.text_mut(at)? = value;
        Ok(())
    }

    /// Returns the link target of a value.
    ///
    /// # Errors
    /// 20 if the value does not exist.
    #[inline]
    pub fn link(&self, at: Place, offset: u32) -> Result<LinkPlace> {
        let index = (at.link + offset) as usize;
        let found = match at.store {
            StoreId::STACK => self.stack.links.get(index),
            id => self.store(id)?.links.get(index),
        };
        found.copied().ok_or(Fault::INDEX_TOO_LARGE)
    }

    /// Links a value.
    ///
    /// # Errors
    /// 20 if the value does not exist, 165 if it is global and the target is local, 82 if it cannot refer to the
    /// target.
    pub fn set_link(&mut self, at: Place, offset: u32, link: LinkPlace) -> Result<()> {
        self.check_link(self.owner(at.store), link)?;
        self.set_file_link(at, offset, link)
    }

    /// Links a value as stated in a file, without a check. The link is checked when it is used.
    ///
    /// # Errors
    /// 20 if the value does not exist.
    pub fn set_file_link(&mut self, at: Place, offset: u32, link: LinkPlace) -> Result<()> {
        let index = (at.link + offset) as usize;
        let found = match at.store {
            StoreId::STACK => self.stack.links.get_mut(index),
            id => self.store_mut(id)?.links.get_mut(index),
        };
        *found.ok_or(Fault::INDEX_TOO_LARGE)? = link;
        Ok(())
    }

    /// Returns the container of a user type's field, or of a local array.
    ///
    /// # Errors
    /// 20 if the value does not exist.
    #[inline]
    pub fn part(&self, at: Place, offset: u32) -> Result<StoreId> {
        let index = (at.part + offset) as usize;
        let found = match at.store {
            StoreId::STACK => self.stack.parts.get(index),
            id => self.store(id)?.parts.get(index),
        };
        found.copied().ok_or(Fault::INDEX_TOO_LARGE)
    }
}

impl Default for Memory {
    fn default() -> Self {
        Self::new()
    }
}
