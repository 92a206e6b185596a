//! Growing and shrinking containers, and keys of collections (2.5.4 to 2.5.6).

use std::ops::Bound;

use super::shape::KEY_BYTES;
use super::store::number_within;
use super::{ContainerShape, Lanes, Memory, Owner, Place, Slot, Store, StoreId, Subscript, View};
use crate::fault::{Fault, Result};
use crate::values::Text;
use crate::values::numbers::round;

/// Maximum size of a variable's values in bytes. An array of 4000 by 4000 numbers is half of it.
const MOST_BYTES: u32 = 1 << 28;

impl Memory {
    /// Number of elements in a view (2.5.4).
    ///
    /// # Errors
    /// 20 if the container does not exist.
    pub fn len(&self, view: View) -> Result<u32> {
        Ok(self.store(view.store)?.shape.len().saturating_sub(view.start))
    }

    /// Size of a dimension, counted from 1; 0 if there is no such dimension.
    ///
    /// # Errors
    /// 20 if the container does not exist.
    pub fn dimension(&self, view: View, dimension: f64) -> Result<u32> {
        let dimension = round(dimension);
        let ContainerShape::Array { dims, sizes } = self.store(view.store)?.shape else {
            return Ok(if dimension == 1.0 { self.len(view)? } else { 0 });
        };
        let found = sizes.iter().take(usize::from(dims)).zip(1u8..).find(|(_, number)| f64::from(*number) == dimension);
        Ok(found.map_or(0, |(size, number)| if number == 1 { size - view.start.min(*size) } else { *size }))
    }

    /// Finds the element of a slot.
    ///
    /// # Errors
    /// 20 and 21 if it does not exist, 80 if the library has no such container.
    pub fn locate(&self, slot: &Slot) -> Result<Place> {
        let view = slot.container()?;
        let store = self.store(view.store)?;
        let number = match slot.at {
            Subscript::Whole => store.number1(view, 0.0),
            Subscript::One(index) => store.number1(view, index),
            Subscript::Two(indexes) => store.number2(indexes),
            Subscript::Three(indexes) => store.number3(indexes),
            Subscript::Key(key) => store.number_of(self.text(key)?),
        };
        Ok(store.place(view.store, number?))
    }

    /// Element address, by number from the start of the view.
    ///
    /// # Errors
    /// 20 beyond the size, or if the container does not exist.
    #[inline]
    pub fn element(&self, view: View, number: u32) -> Result<Place> {
        let store = self.store(view.store)?;
        let number = view.start + number;
        if store.has_value(number) { Ok(store.place(view.store, number)) } else { Err(Fault::INDEX_TOO_LARGE) }
    }

    /// Inserts a default value before an index, or at the end (2.5.4).
    ///
    /// # Errors
    /// 20 and 21 for an invalid index, 40 beyond `limit` elements or without memory, 70 for a local or multidimensional
    /// array.
    pub fn insert_at(&mut self, view: View, index: f64, limit: Option<u32>) -> Result<()> {
        let store = self.growing(view.store, limit)?;
        let ContainerShape::Array { dims: 1, sizes: [size, ..] } = store.shape else {
            return Err(Fault::INVALID_PARAMETER);
        };
        let number = number_within(view, size + 1, index)?;
        let parts = self.parts_of_new_value(view.store)?;
        let store = self.store_mut(view.store)?;
        let (before, kind) = (store.kind.size * number, store.kind.clone());
        store.shape = ContainerShape::array(size + 1);
        splice(&mut store.nums, before.num, &kind.default.nums);
        splice(&mut store.texts, before.text, &kind.default.texts);
        splice(&mut store.links, before.link, &kind.default.links);
        splice(&mut store.parts, before.part, &parts);
        Ok(())
    }

    /// Inserts a default value under a key; returns `false` if the key exists (2.5.4).
    ///
    /// # Errors
    /// 40 beyond `limit` elements or without memory, 70 for an array or an empty key.
    pub fn insert_key(&mut self, id: StoreId, key: Text, limit: Option<u32>) -> Result<bool> {
        let store = self.store(id)?;
        let ContainerShape::Collection(keys) = &store.shape else { return Err(Fault::INVALID_PARAMETER) };
        if keys.contains_key(&key) {
            return Ok(false);
        }
        if key.as_str().is_empty() {
            return Err(Fault::INVALID_PARAMETER);
        }
        let gap = self.growing(id, limit)?.gaps.last().copied();
        self.stores.room.check(KEY_BYTES)?;
        let number = match gap {
            Some(number) => {
                self.reset(id, number)?;
                self.store_mut(id)?.gaps.pop();
                number
            }
            None => {
                self.push(id)?;
                self.store(id)?.shape.len()
            }
        };
        if let ContainerShape::Collection(keys) = &mut self.store_mut(id)?.shape {
            keys.insert(key, number);
        }
        self.stores.room.take(KEY_BYTES)?;
        Ok(true)
    }

    /// Appends a default value (2.5.5).
    ///
    /// # Errors
    /// 40 beyond `limit` elements or without memory, 70 for a local or multidimensional array.
    pub fn append(&mut self, id: StoreId, limit: Option<u32>) -> Result<()> {
        let store = self.growing(id, limit)?;
        let ContainerShape::Array { dims: 1, sizes: [size, ..] } = store.shape else {
            return Err(Fault::INVALID_PARAMETER);
        };
        self.push(id)?;
        self.store_mut(id)?.shape = ContainerShape::array(size + 1);
        Ok(())
    }

    /// Removes the element at an index (2.5.4). An array keeps at least one element.
    ///
    /// # Errors
    /// 20 and 21 for an invalid index, 70 for the last element, and for a local or multidimensional array.
    pub fn delete_at(&mut self, view: View, index: f64) -> Result<()> {
        let store = self.changing(view.store)?;
        let ContainerShape::Array { dims: 1, sizes: [size, ..] } = store.shape else {
            return Err(Fault::INVALID_PARAMETER);
        };
        let number = store.number1(view, index)?;
        if size == 1 {
            return Err(Fault::INVALID_PARAMETER);
        }
        let (at, one) = (store.kind.size * number, store.kind.size);
        cut(&mut store.nums, at.num, one.num);
        cut(&mut store.texts, at.text, one.text);
        cut(&mut store.links, at.link, one.link);
        let parts = cut(&mut store.parts, at.part, one.part);
        store.shape = ContainerShape::array(size - 1);
        self.stores.room.give_back(one.bytes());
        parts.into_iter().for_each(|part| self.remove(part));
        Ok(())
    }

    /// Removes the element under a key (2.5.4).
    ///
    /// # Errors
    /// 20 if the key does not exist, 70 for an array.
    pub fn delete_key(&mut self, id: StoreId, key: &Text) -> Result<()> {
        let store = self.changing(id)?;
        let ContainerShape::Collection(keys) = &mut store.shape else { return Err(Fault::INVALID_PARAMETER) };
        let number = keys.remove(key).ok_or(Fault::INDEX_TOO_LARGE)?;
        let parts = store.clear_value(number);
        self.stores.room.give_back(KEY_BYTES);
        parts.into_iter().for_each(|part| self.remove(part));
        Ok(())
    }

    /// Changes the size of a dimension, counted from 1; elements keep their indexes (2.5.5). The size is the size of
    /// the part in the view.
    ///
    /// # Errors
    /// 40 beyond `limit` elements or without memory, 70 for a local array, a collection, a missing dimension or a size
    /// below 1.
    pub fn resize(&mut self, view: View, dimension: f64, size: f64, limit: Option<u32>) -> Result<()> {
        let store = self.changing(view.store)?;
        let ContainerShape::Array { dims, sizes: old } = store.shape else { return Err(Fault::INVALID_PARAMETER) };
        let (dimension, size) = (round(dimension), round(size));
        let which = (0..usize::from(dims)).zip(1u8..).find(|(_, number)| f64::from(*number) == dimension);
        let (Some((which, _)), true) = (which, size >= 1.0) else { return Err(Fault::INVALID_PARAMETER) };
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "at least 1; too large saturates")]
        let size = (size as u32).saturating_add(view.start);
        let mut new = old;
        if let Some(changed) = new.get_mut(which) {
            *changed = size;
        }
        let count = new.iter().try_fold(1u32, |product, size| product.checked_mul(*size)).ok_or(Fault::NO_MEMORY)?;
        if count > most_values(store.kind.size, limit) {
            return Err(Fault::NO_MEMORY);
        }
        self.rearrange(view.store, old, new, dims)
    }

    /// Moves array elements to their positions for other sizes.
    pub(super) fn rearrange(&mut self, id: StoreId, old: [u32; 3], new: [u32; 3], dims: u8) -> Result<()> {
        let store = self.store(id)?;
        let (kind, owner, before) = (store.kind.clone(), store.owner, store.bytes());
        let shape = ContainerShape::Array { dims, sizes: new };
        let after = shape.bytes(kind.size);
        self.stores.room.check(after.saturating_sub(before))?;
        let kept: u32 = old.iter().zip(new).map(|(old, new)| new.min(*old)).product();
        let added = if kind.size.part > 0 { shape.len() - kept } else { 0 };
        let fresh = self.create_parts(&kind, (0..added).map(|_| None), owner)?;
        if let Err(fault) = self.stores.room.take(after.saturating_sub(before)) {
            fresh.into_iter().for_each(|part| self.remove(part));
            return Err(fault);
        }
        self.stores.room.give_back(before.saturating_sub(after));
        let store = self.store_mut(id)?;
        let lost = store.rearrange(old, new, shape, fresh);
        lost.into_iter().for_each(|part| self.remove(part));
        Ok(())
    }

    /// First key of a collection within these bounds.
    ///
    /// # Errors
    /// 70 for an array.
    pub fn key_from(&self, id: StoreId, from: Bound<&Text>) -> Result<Option<Text>> {
        match &self.store(id)?.shape {
            ContainerShape::Collection(keys) => Ok(keys.range((from, Bound::Unbounded)).next().map(|(key, _)| *key)),
            ContainerShape::Array { .. } => Err(Fault::INVALID_PARAMETER),
        }
    }

    /// Last key of a collection within these bounds.
    ///
    /// # Errors
    /// 70 for an array.
    pub fn key_up_to(&self, id: StoreId, to: Bound<&Text>) -> Result<Option<Text>> {
        match &self.store(id)?.shape {
            ContainerShape::Collection(keys) => Ok(keys.range((Bound::Unbounded, to)).next_back().map(|(key, _)| *key)),
            ContainerShape::Array { .. } => Err(Fault::INVALID_PARAMETER),
        }
    }

    /// Returns a container whose size may change.
    fn changing(&mut self, id: StoreId) -> Result<&mut Store> {
        let store = self.store_mut(id)?;
        if store.owner == Owner::Program && !store.field { Err(Fault::INVALID_PARAMETER) } else { Ok(store) }
    }

    /// Returns a container to which an element can be added.
    fn growing(&mut self, id: StoreId, limit: Option<u32>) -> Result<&mut Store> {
        let store = self.changing(id)?;
        let most = most_values(store.kind.size, limit);
        if store.shape.len() >= most { Err(Fault::NO_MEMORY) } else { Ok(store) }
    }

    /// Appends the lanes of a default value.
    fn push(&mut self, id: StoreId) -> Result<()> {
        let parts = self.parts_of_new_value(id)?;
        let store = self.store_mut(id)?;
        store.push_default();
        store.parts.extend(parts);
        Ok(())
    }

    /// Allocates the memory for one more element, and creates its inner containers.
    fn parts_of_new_value(&mut self, id: StoreId) -> Result<Vec<StoreId>> {
        let store = self.store(id)?;
        let bytes = store.kind.size.bytes();
        let parts = match store.kind.size.part {
            0 => Vec::new(),
            _ => {
                let (kind, owner) = (store.kind.clone(), store.owner);
                self.create_parts(&kind, [None], owner)?
            }
        };
        if let Err(fault) = self.stores.room.take(bytes) {
            parts.into_iter().for_each(|part| self.remove(part));
            return Err(fault);
        }
        Ok(parts)
    }
}

/// Maximum number of elements in a variable, for this element size.
fn most_values(size: Lanes, limit: Option<u32>) -> u32 {
    let bytes = 8 * size.num + 132 * size.text + 32 * size.link + 256 * size.part;
    limit.unwrap_or(u32::MAX).min(MOST_BYTES / bytes.max(1))
}

fn splice<T: Copy>(lanes: &mut Vec<T>, at: u32, values: &[T]) {
    let at = (at as usize).min(lanes.len());
    lanes.splice(at..at, values.iter().copied());
}

fn cut<T>(lanes: &mut Vec<T>, at: u32, count: u32) -> Vec<T> {
    let end = ((at + count) as usize).min(lanes.len());
    lanes.drain((at as usize).min(end)..end).collect()
}
