//! Data of running programs: containers of values, task stacks, and references between values (2.3 to 2.6).
//!
//! A value is divided into lanes: numbers, truth values and enumerators are in the lane `num`, strings in `text`, and
//! references to other data, inputs, outputs and screens in `link`. A value of a user type has a container for each of
//! its fields in the lane `part`, because the fields of a type are data with containers (7.2). A number therefore
//! always occupies eight bytes, and a point nine numbers and one link.

mod assign;
mod budget;
mod containers;
mod copy;
mod display;
mod kind;
mod lanes;
#[cfg(test)]
mod laws;
mod layout;
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
        let nums = match at.store {
            StoreId::STACK => &self.stack.nums,
            _ => match self.stores.with_layout(at) {
                Some(store) => &store.nums,
                None => return self.num(self.stores.moved(at)?, offset),
            },
        };
        nums.get((at.num + offset) as usize).copied().ok_or(Fault::INDEX_TOO_LARGE)
    }

    /// Writes a value that [`num`](Self::num) reads.
    ///
    /// # Errors
    /// 20 if the value does not exist.
    #[inline]
    pub fn set_num(&mut self, at: Place, offset: u32, value: f64) -> Result<()> {
        let nums = match at.store {
            StoreId::STACK => &mut self.stack.nums,
            _ => match self.stores.with_layout_mut(at) {
                Some(store) => &mut store.nums,
                None => return self.set_num(self.stores.moved(at)?, offset, value),
            },
        };
        *nums.get_mut((at.num + offset) as usize).ok_or(Fault::INDEX_TOO_LARGE)? = value;
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
            _ => match self.stores.with_layout(at) {
                Some(store) => &store.nums,
                None => return self.nums(self.stores.moved(at)?, offset),
            },
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
            _ => match self.stores.with_layout_mut(at) {
                Some(store) => &mut store.nums,
                None => return self.set_nums(self.stores.moved(at)?, offset, values),
            },
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
        let texts = match at.store {
            StoreId::STACK => &self.stack.texts,
            _ => match self.stores.with_layout(at) {
                Some(store) => &store.texts,
                None => return self.text(self.stores.moved(at)?),
            },
        };
        texts.get(at.text as usize).ok_or(Fault::INDEX_TOO_LARGE)
    }

    /// Returns a string for writing.
    ///
    /// # Errors
    /// 20 if the value does not exist.
    #[inline]
    pub fn text_mut(&mut self, at: Place) -> Result<&mut Text> {
        let at = self.present(at)?;
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

    /// Converts an address to the present layout of its container, for a comparison with other addresses, or for a
    /// look at its lanes. Access to values does not require it.
    ///
    /// # Errors
    /// 20 if the container, the key or the indexes of the value do not exist any more. An address beyond the end of an
    /// array that has only been shortened is unchanged.
    #[inline]
    pub fn present(&self, at: Place) -> Result<Place> {
        match at.store {
            StoreId::STACK => Ok(at),
            _ if self.stores.with_layout(at).is_some() => Ok(at),
            _ => self.stores.moved(at),
        }
    }

    /// Returns the link target of a value. The address of a target that moved within its container is the present one,
    /// so that equal targets are equal.
    ///
    /// # Errors
    /// 20 if the value does not exist.
    #[inline]
    pub fn link(&self, at: Place, offset: u32) -> Result<LinkPlace> {
        let links = match at.store {
            StoreId::STACK => &self.stack.links,
            _ => match self.stores.with_layout(at) {
                Some(store) => &store.links,
                None => return self.link(self.stores.moved(at)?, offset),
            },
        };
        match links.get((at.link + offset) as usize).copied().ok_or(Fault::INDEX_TOO_LARGE)? {
            LinkPlace::Data(target) => Ok(LinkPlace::Data(self.present(target).unwrap_or(target))),
            link => Ok(link),
        }
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
        let at = self.present(at)?;
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
        let parts = match at.store {
            StoreId::STACK => &self.stack.parts,
            _ => match self.stores.with_layout(at) {
                Some(store) => &store.parts,
                None => return self.part(self.stores.moved(at)?, offset),
            },
        };
        parts.get((at.part + offset) as usize).copied().ok_or(Fault::INDEX_TOO_LARGE)
    }
}

impl Default for Memory {
    fn default() -> Self {
        Self::new()
    }
}
