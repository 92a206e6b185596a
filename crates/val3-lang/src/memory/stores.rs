//! The containers, each under an identity that no later one has.

use super::{Store, StoreId, View};
use crate::fault::{Fault, Result};

/// All containers of a controller.
#[derive(Debug, Clone, Default)]
pub struct Stores {
    items: Vec<Store>,
    free: Vec<u32>,
}

impl Stores {
    /// Takes a container in; it lives until [`remove`](Self::remove).
    pub fn add(&mut self, mut store: Store) -> StoreId {
        if let Some(index) = self.free.pop()
            && let Some(slot) = self.items.get_mut(index as usize)
        {
            store.generation = slot.generation + 1;
            let generation = store.generation;
            *slot = store;
            return StoreId { index, generation };
        }
        let index = u32::try_from(self.items.len()).unwrap_or(u32::MAX);
        self.items.push(store);
        StoreId { index, generation: 0 }
    }

    /// Drops a container and those in it. References to it end in run-time error 61.
    pub fn remove(&mut self, id: StoreId) {
        let Ok(store) = self.get_mut(id) else { return };
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
    pub fn get(&self, id: StoreId) -> Result<&Store> {
        self.living(id).ok_or(Fault::INTERPRETER)
    }

    /// As [`get`](Self::get), to be changed.
    ///
    /// # Errors
    /// 61 if it is gone.
    #[inline]
    pub fn get_mut(&mut self, id: StoreId) -> Result<&mut Store> {
        self.living_mut(id).ok_or(Fault::INTERPRETER)
    }

    #[inline]
    fn living(&self, id: StoreId) -> Option<&Store> {
        self.items.get(id.index as usize).filter(|store| store.generation == id.generation)
    }

    #[inline]
    fn living_mut(&mut self, id: StoreId) -> Option<&mut Store> {
        self.items.get_mut(id.index as usize).filter(|store| store.generation == id.generation)
    }
}

/// Numbers of arrays, without a place in between: what loops over numbers do most.
impl Stores {
    /// A number of the first value of a view.
    ///
    /// # Errors
    /// 20 if there is none.
    #[inline]
    pub fn first_num(&self, view: View, lane: u32) -> Result<f64> {
        let store = self.get(view.store)?;
        let at = view.start * store.kind.size.num + lane;
        store.nums.get(at as usize).copied().ok_or(Fault::INDEX_TOO_LARGE)
    }

    /// Writes what [`first_num`](Self::first_num) reads.
    ///
    /// # Errors
    /// 20 if there is no value.
    #[inline]
    pub fn set_first_num(&mut self, view: View, lane: u32, value: f64) -> Result<()> {
        let store = self.get_mut(view.store)?;
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
        let found = self.living(view.store).and_then(|store| store.nums.get(store.lane1(view, index)?));
        found.copied().ok_or_else(|| self.fault1(view, index))
    }

    /// Writes what [`element_num`](Self::element_num) reads.
    ///
    /// # Errors
    /// 21 for an index below zero, 20 for one beyond the size.
    #[inline]
    pub fn set_element_num(&mut self, view: View, index: f64, value: f64) -> Result<()> {
        let store = self.living_mut(view.store);
        if let Some(number) = store.and_then(|store| store.lane1(view, index).and_then(|lane| store.nums.get_mut(lane)))
        {
            *number = value;
            return Ok(());
        }
        Err(self.fault1(view, index))
    }

    /// Why there is no value under an index.
    #[cold]
    fn fault1(&self, view: View, index: f64) -> Fault {
        self.get(view.store).and_then(|store| store.number1(view, index)).err().unwrap_or(Fault::INDEX_TOO_LARGE)
    }

    /// A value of an array of numbers or truth values of two dimensions.
    ///
    /// # Errors
    /// 21 for an index below zero, 20 for one beyond the size.
    #[inline]
    pub fn element2_num(&self, id: StoreId, at: [f64; 2]) -> Result<f64> {
        let found = self.living(id).and_then(|store| store.nums.get(store.lane2(at)?));
        found.copied().ok_or_else(|| self.fault2(id, at))
    }

    /// Writes what [`element2_num`](Self::element2_num) reads.
    ///
    /// # Errors
    /// 21 for an index below zero, 20 for one beyond the size.
    #[inline]
    pub fn set_element2_num(&mut self, id: StoreId, at: [f64; 2], value: f64) -> Result<()> {
        let store = self.living_mut(id);
        if let Some(number) = store.and_then(|store| store.lane2(at).and_then(|lane| store.nums.get_mut(lane))) {
            *number = value;
            return Ok(());
        }
        Err(self.fault2(id, at))
    }

    /// Why there is no value under two indexes.
    #[cold]
    fn fault2(&self, id: StoreId, at: [f64; 2]) -> Fault {
        self.get(id).and_then(|store| store.number2(at)).err().unwrap_or(Fault::INDEX_TOO_LARGE)
    }
}
