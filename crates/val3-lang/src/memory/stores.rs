//! All containers, by unique identity.

use super::{MemoryBudget, Place, Store, StoreId, View};
use crate::fault::{Fault, Result};
use crate::values::Text;

/// Containers of a controller.
#[derive(Debug, Clone, Default)]
pub struct Stores {
    items: Vec<Store>,
    free: Vec<u32>,
    /// Memory that containers share with stacks, tasks and code.
    pub room: MemoryBudget,
}

impl Stores {
    /// Adds a container, which exists until [`remove`](Self::remove).
    ///
    /// # Errors
    /// 40 without memory. Its inner containers are then removed.
    pub fn add(&mut self, mut store: Store) -> Result<StoreId> {
        if let Err(fault) = self.room.take(store.bytes()) {
            store.parts.into_iter().for_each(|part| self.remove(part));
            return Err(fault);
        }
        if let Some(index) = self.free.pop()
            && let Some(slot) = self.items.get_mut(index as usize)
        {
            let generation = slot.next_layout();
            store.begin(generation);
            *slot = store;
            return Ok(StoreId { index, generation });
        }
        store.begin(0);
        let index = u32::try_from(self.items.len()).unwrap_or(u32::MAX);
        self.items.push(store);
        Ok(StoreId { index, generation: 0 })
    }

    /// Removes a container and its inner containers. References to them cause run-time error 20.
    pub fn remove(&mut self, id: StoreId) {
        let Ok(store) = self.get_mut(id) else { return };
        let bytes = store.bytes();
        let parts = store.empty();
        self.free.push(id.index);
        self.room.give_back(bytes);
        parts.into_iter().for_each(|part| self.remove(part));
    }

    /// Copies the values of a container to another container with the same type and sizes. If sizes differ or there are
    /// inner containers, returns `false` without a change.
    ///
    /// # Errors
    /// 20 if one of them does not exist.
    pub(super) fn overwrite(&mut self, to: StoreId, from: StoreId) -> Result<bool> {
        self.get(to).and(self.get(from))?;
        let indexes = [to.index as usize, from.index as usize];
        let [to, from] = self.items.get_disjoint_mut(indexes).map_err(|_| Fault::INTERPRETER)?;
        Ok(to.overwrite(from))
    }

    /// Returns a container.
    ///
    /// # Errors
    /// 20 if it does not exist.
    #[inline]
    pub fn get(&self, id: StoreId) -> Result<&Store> {
        self.living(id).ok_or(Fault::INDEX_TOO_LARGE)
    }

    /// As [`get`](Self::get), mutable.
    ///
    /// # Errors
    /// 20 if it does not exist.
    #[inline]
    pub fn get_mut(&mut self, id: StoreId) -> Result<&mut Store> {
        self.living_mut(id).ok_or(Fault::INDEX_TOO_LARGE)
    }

    /// Returns a value's container, if the container still has the layout of the address.
    #[inline(always)]
    pub(super) fn with_layout(&self, at: Place) -> Option<&Store> {
        self.items.get(at.store.index as usize).filter(|store| store.layout == at.layout)
    }

    /// As [`with_layout`](Self::with_layout), mutable.
    #[inline(always)]
    pub(super) fn with_layout_mut(&mut self, at: Place) -> Option<&mut Store> {
        self.items.get_mut(at.store.index as usize).filter(|store| store.layout == at.layout)
    }

    /// Converts an address for an earlier layout of the container to the present layout.
    ///
    /// # Errors
    /// 20 if the value does not exist any more.
    #[cold]
    pub(super) fn moved(&self, at: Place) -> Result<Place> {
        let store = self.get(at.store)?;
        store.moved(at).ok_or(Fault::INDEX_TOO_LARGE)
    }

    #[inline(always)]
    fn living(&self, id: StoreId) -> Option<&Store> {
        self.items.get(id.index as usize).filter(|store| store.generation == id.generation)
    }

    #[inline(always)]
    fn living_mut(&mut self, id: StoreId) -> Option<&mut Store> {
        self.items.get_mut(id.index as usize).filter(|store| store.generation == id.generation)
    }
}

/// Direct access to numbers in containers, the most frequent operation of loops. `None` means any error;
/// [`Memory::element`](super::Memory::element) and [`Store::number1`] return its number.
impl Stores {
    /// Number in lane `lane` of a view's first element.
    #[inline(always)]
    #[must_use]
    pub fn first(&self, view: View, lane: u16) -> Option<&f64> {
        let store = self.living(view.store)?;
        store.nums.get((view.start * store.kind.size.num) as usize + usize::from(lane))
    }

    /// As [`first`](Self::first), mutable.
    #[inline(always)]
    pub fn first_mut(&mut self, view: View, lane: u16) -> Option<&mut f64> {
        let store = self.living_mut(view.store)?;
        store.nums.get_mut((view.start * store.kind.size.num) as usize + usize::from(lane))
    }

    /// Container of a field in a view's first element.
    #[inline(always)]
    #[must_use]
    pub fn field(&self, view: View, field: u16) -> Option<StoreId> {
        let store = self.living(view.store)?;
        store.parts.get((view.start * store.kind.size.part) as usize + usize::from(field)).copied()
    }

    /// Container of a field in an array element.
    #[inline(always)]
    #[must_use]
    pub fn element_field(&self, view: View, index: f64, field: u16) -> Option<StoreId> {
        let store = self.living(view.store)?;
        let value = store.lane1(view, index)?;
        store.parts.get(value * store.kind.size.part as usize + usize::from(field)).copied()
    }

    /// Address of a view's first element.
    #[inline(always)]
    #[must_use]
    pub fn first_place(&self, view: View) -> Option<Place> {
        let store = self.living(view.store)?;
        (view.start < store.shape.len()).then(|| store.place(view.store, view.start))
    }

    /// Array element's address.
    #[inline(always)]
    #[must_use]
    pub fn element_place(&self, view: View, index: f64) -> Option<Place> {
        let store = self.living(view.store)?;
        let number = u32::try_from(store.lane1(view, index)?).ok()?;
        (number < store.shape.len()).then(|| store.place(view.store, number))
    }

    /// String in a view's first element.
    #[inline(always)]
    #[must_use]
    pub fn first_text(&self, view: View) -> Option<&Text> {
        self.living(view.store)?.texts.get(view.start as usize)
    }

    /// As [`first_text`](Self::first_text), mutable.
    #[inline(always)]
    pub fn first_text_mut(&mut self, view: View) -> Option<&mut Text> {
        self.living_mut(view.store)?.texts.get_mut(view.start as usize)
    }

    /// Element in a number or bool array.
    #[inline(always)]
    #[must_use]
    pub fn element(&self, view: View, index: f64) -> Option<&f64> {
        let store = self.living(view.store)?;
        store.nums.get(store.lane1(view, index)?)
    }

    /// As [`element`](Self::element), mutable.
    #[inline(always)]
    pub fn element_mut(&mut self, view: View, index: f64) -> Option<&mut f64> {
        let store = self.living_mut(view.store)?;
        let lane = store.lane1(view, index)?;
        store.nums.get_mut(lane)
    }

    /// Element in a two-dimensional number or bool array.
    #[inline(always)]
    #[must_use]
    pub fn element2(&self, view: View, at: [f64; 2]) -> Option<&f64> {
        let store = self.living(view.store)?;
        store.nums.get(store.lane2(at)?)
    }

    /// As [`element2`](Self::element2), mutable.
    #[inline(always)]
    pub fn element2_mut(&mut self, view: View, at: [f64; 2]) -> Option<&mut f64> {
        let store = self.living_mut(view.store)?;
        let lane = store.lane2(at)?;
        store.nums.get_mut(lane)
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::{Store, Stores};
    use crate::memory::{ContainerShape, ValueType};
    use crate::types::BaseType;

    #[test]
    fn a_copy_of_a_later_container_is_found() {
        let mut stores = Stores::default();
        let store = Store::filled(Arc::new(ValueType::builtin(BaseType::Num, None)), ContainerShape::ELEMENT);
        let first = stores.add(store.clone()).unwrap();
        stores.remove(first);
        let second = stores.add(store).unwrap();
        let copied = stores.get(second).unwrap().clone();
        let copy = stores.add(copied).unwrap();
        assert!(stores.get(copy).is_ok());
        assert!(stores.get(first).is_err());
    }
}
