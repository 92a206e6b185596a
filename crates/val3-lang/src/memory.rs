//! The data of running programs: containers of values, the stacks of tasks, and references between them (2.3 to 2.6).
//!
//! A value is spread over lanes: numbers, truth values and enumerators are in the lane `num`, texts in `text`,
//! references to other data, inputs, outputs and screens in `link`. A value of a user type has a container for each of
//! its fields in the lane `part` (7.2: the fields of a type are data, each with a container). So a number costs eight
//! bytes wherever it is, and a point is nine numbers and one link.

mod containers;
mod copy;
mod kind;
mod lanes;
mod lifetime;
mod place;
mod shown;
mod stack;
mod store;

pub use kind::{Element, FieldKind, Kind, KindBase, PartInit, enumerator, field_offset, path_offset};
pub use lanes::Lanes;
pub use place::{Link, Place, Slot, SlotAt, StoreId, View};
pub use stack::Stack;
pub use store::{Shape, Store};

use std::sync::Arc;

use crate::fault::{Fault, Result};
use crate::types::BaseType;
use crate::values::Text;

/// All data of a controller, and the stack of the task that runs.
#[derive(Debug, Clone)]
pub struct Memory {
    stores: Vec<Store>,
    free: Vec<u32>,
    /// The stack of the task that runs; [`Place::store`] names it [`StoreId::STACK`].
    pub stack: Stack,
}

impl Memory {
    /// The data that every controller has: `world` and `flange`.
    #[must_use]
    pub fn new() -> Self {
        let mut memory = Self { stores: Vec::new(), free: Vec::new(), stack: Stack::default() };
        for base in [BaseType::Frame, BaseType::Tool] {
            let kind = Arc::new(Kind::builtin(base, None));
            memory.add(Store::filled(kind, Shape::ELEMENT));
        }
        memory
    }

    /// The variable `world` (9.4).
    pub const WORLD: StoreId = StoreId { index: 0, generation: 0 };

    /// The variable `flange` (9.5).
    pub const FLANGE: StoreId = StoreId { index: 1, generation: 0 };

    /// Takes a container in; it lives until [`remove`](Self::remove).
    pub fn add(&mut self, mut store: Store) -> StoreId {
        if let Some(index) = self.free.pop()
            && let Some(slot) = self.stores.get_mut(index as usize)
        {
            store.generation = slot.generation + 1;
            let generation = store.generation;
            *slot = store;
            return StoreId { index, generation };
        }
        let index = u32::try_from(self.stores.len()).unwrap_or(u32::MAX);
        self.stores.push(store);
        StoreId { index, generation: 0 }
    }

    /// Drops a container and those in it. References to it end in run-time error 61.
    pub fn remove(&mut self, id: StoreId) {
        let Ok(store) = self.store_mut(id) else { return };
        let generation = store.generation;
        let parts = std::mem::take(&mut store.parts);
        *store = Store::gone(generation + 1);
        self.free.push(id.index);
        parts.into_iter().for_each(|part| self.remove(part));
    }

    /// A container.
    ///
    /// # Errors
    /// 61 if it is gone.
    #[inline]
    pub fn store(&self, id: StoreId) -> Result<&Store> {
        match self.stores.get(id.index as usize) {
            Some(store) if store.generation == id.generation => Ok(store),
            _ => Err(Fault::INTERPRETER),
        }
    }

    /// As [`store`](Self::store), to be changed.
    ///
    /// # Errors
    /// 61 if it is gone.
    #[inline]
    pub fn store_mut(&mut self, id: StoreId) -> Result<&mut Store> {
        match self.stores.get_mut(id.index as usize) {
            Some(store) if store.generation == id.generation => Ok(store),
            _ => Err(Fault::INTERPRETER),
        }
    }

    /// A number, truth value (0 or 1) or enumerator (its place among those of its type), `offset` lanes behind `at`.
    ///
    /// # Errors
    /// 20 if the value is gone.
    #[inline]
    pub fn num(&self, at: Place, offset: u32) -> Result<f64> {
        let index = (at.num + offset) as usize;
        let found = match at.store {
            StoreId::STACK => self.stack.nums.get(index),
            id => self.store(id)?.nums.get(index),
        };
        found.copied().ok_or(Fault::INDEX_TOO_LARGE)
    }

    /// Writes what [`num`](Self::num) reads.
    ///
    /// # Errors
    /// 20 if the value is gone.
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

    /// `N` numbers from `at` on: a transformation, a joint position.
    ///
    /// # Errors
    /// 20 if the value is gone.
    pub fn nums<const N: usize>(&self, at: Place, offset: u32) -> Result<[f64; N]> {
        let index = (at.num + offset) as usize;
        let nums = match at.store {
            StoreId::STACK => &self.stack.nums,
            id => &self.store(id)?.nums,
        };
        nums.get(index..).and_then(|rest| rest.first_chunk()).copied().ok_or(Fault::INDEX_TOO_LARGE)
    }

    /// Writes `N` numbers from `at` on.
    ///
    /// # Errors
    /// 20 if the value is gone.
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

    /// A text.
    ///
    /// # Errors
    /// 20 if the value is gone.
    pub fn text(&self, at: Place) -> Result<&Text> {
        let found = match at.store {
            StoreId::STACK => self.stack.texts.get(at.text as usize),
            id => self.store(id)?.texts.get(at.text as usize),
        };
        found.ok_or(Fault::INDEX_TOO_LARGE)
    }

    /// Writes a text.
    ///
    /// # Errors
    /// 20 if the value is gone.
    pub fn set_text(&mut self, at: Place, value: Text) -> Result<()> {
        let found = match at.store {
            StoreId::STACK => self.stack.texts.get_mut(at.text as usize),
            id => self.store_mut(id)?.texts.get_mut(at.text as usize),
        };
        *found.ok_or(Fault::INDEX_TOO_LARGE)? = value;
        Ok(())
    }

    /// What a value is linked to.
    ///
    /// # Errors
    /// 20 if the value is gone.
    pub fn link(&self, at: Place, offset: u32) -> Result<Link> {
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
    /// 20 if the value is gone, 165 if it is global and would refer to a local one.
    pub fn set_link(&mut self, at: Place, offset: u32, link: Link) -> Result<()> {
        self.check_link(self.is_local(at.store), link)?;
        let index = (at.link + offset) as usize;
        let found = match at.store {
            StoreId::STACK => self.stack.links.get_mut(index),
            id => self.store_mut(id)?.links.get_mut(index),
        };
        *found.ok_or(Fault::INDEX_TOO_LARGE)? = link;
        Ok(())
    }

    /// The container of a field of a user type, or of a local array.
    ///
    /// # Errors
    /// 20 if the value is gone.
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

/// Numbers of arrays, without a place in between: what loops over numbers do most.
impl Memory {
    /// A number of the first value of a view.
    ///
    /// # Errors
    /// 20 if there is none.
    #[inline]
    pub fn first_num(&self, view: View, lane: u32) -> Result<f64> {
        let store = self.store(view.store)?;
        let at = view.start * store.kind.size.num + lane;
        store.nums.get(at as usize).copied().ok_or(Fault::INDEX_TOO_LARGE)
    }

    /// Writes what [`first_num`](Self::first_num) reads.
    ///
    /// # Errors
    /// 20 if there is no value.
    #[inline]
    pub fn set_first_num(&mut self, view: View, lane: u32, value: f64) -> Result<()> {
        let store = self.store_mut(view.store)?;
        let at = view.start * store.kind.size.num + lane;
        *store.nums.get_mut(at as usize).ok_or(Fault::INDEX_TOO_LARGE)? = value;
        Ok(())
    }

    /// A value of an array of numbers or truth values.
    ///
    /// # Errors
    /// 21 for an index below zero, 20 for one beyond the size.
    #[inline]
    pub fn element_num(&self, view: View, index: f64) -> Result<f64> {
        let store = self.store(view.store)?;
        let number = store.number1(view, index)?;
        store.nums.get(number as usize).copied().ok_or(Fault::INDEX_TOO_LARGE)
    }

    /// Writes what [`element_num`](Self::element_num) reads.
    ///
    /// # Errors
    /// 21 for an index below zero, 20 for one beyond the size.
    #[inline]
    pub fn set_element_num(&mut self, view: View, index: f64, value: f64) -> Result<()> {
        let store = self.store_mut(view.store)?;
        let number = store.number1(view, index)?;
        *store.nums.get_mut(number as usize).ok_or(Fault::INDEX_TOO_LARGE)? = value;
        Ok(())
    }

    /// A value of an array of numbers or truth values of two dimensions.
    ///
    /// # Errors
    /// 21 for an index below zero, 20 for one beyond the size.
    #[inline]
    pub fn element2_num(&self, id: StoreId, at: [f64; 2]) -> Result<f64> {
        let store = self.store(id)?;
        let number = store.number2(at)?;
        store.nums.get(number as usize).copied().ok_or(Fault::INDEX_TOO_LARGE)
    }

    /// Writes what [`element2_num`](Self::element2_num) reads.
    ///
    /// # Errors
    /// 21 for an index below zero, 20 for one beyond the size.
    #[inline]
    pub fn set_element2_num(&mut self, id: StoreId, at: [f64; 2], value: f64) -> Result<()> {
        let store = self.store_mut(id)?;
        let number = store.number2(at)?;
        *store.nums.get_mut(number as usize).ok_or(Fault::INDEX_TOO_LARGE)? = value;
        Ok(())
    }
}
