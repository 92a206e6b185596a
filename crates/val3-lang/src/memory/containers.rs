//! Containers that grow and shrink, and the keys of collections (2.5.4 to 2.5.6).

use std::ops::Bound;

use super::store::number_within;
use super::{Lanes, Memory, Owner, Place, Shape, Slot, SlotAt, Store, StoreId, View};
use crate::fault::{Fault, Result};
use crate::values::Text;
use crate::values::numbers::round;

/// Bytes that the values of a variable may take, whatever their number: a grid of 4000 by 4000 numbers is half of it.
const MOST_BYTES: u32 = 1 << 28;

impl Memory {
    /// The number of values that can be reached through a view (2.5.4).
    ///
    /// # Errors
    /// 20 if the container is gone.
    pub fn len(&self, view: View) -> Result<u32> {
        Ok(self.store(view.store)?.shape.len().saturating_sub(view.start))
    }

    /// The size of a dimension, counted from 1; 0 where there is none of that number.
    ///
    /// # Errors
    /// 20 if the container is gone.
    pub fn dimension(&self, view: View, dimension: f64) -> Result<u32> {
        let dimension = round(dimension);
        let Shape::Array { dims, sizes } = self.store(view.store)?.shape else {
            return Ok(if dimension == 1.0 { self.len(view)? } else { 0 });
        };
        let found = sizes.iter().take(usize::from(dims)).zip(1u8..).find(|(_, number)| f64::from(*number) == dimension);
        Ok(found.map_or(0, |(size, number)| if number == 1 { size - view.start.min(*size) } else { *size }))
    }

    /// The value that a slot names.
    ///
    /// # Errors
    /// 20 and 21 if there is none, 80 if the library lacks the container.
    pub fn locate(&self, slot: &Slot) -> Result<Place> {
        let view = slot.container()?;
        let store = self.store(view.store)?;
        let number = match slot.at {
            SlotAt::Whole => store.number1(view, 0.0),
            SlotAt::Index([index, ..], 1) => store.number1(view, index),
            SlotAt::Index([i, j, _], 2) => store.number2([i, j]),
            SlotAt::Index(indexes, _) => store.number3(indexes),
            SlotAt::Key(key) => store.number_of(&key),
        };
        Ok(store.place(view.store, number?))
    }

    /// A value of a view by its number from the start of the view.
    ///
    /// # Errors
    /// 20 beyond the size, or if the container is gone.
    pub fn element(&self, view: View, number: u32) -> Result<Place> {
        let store = self.store(view.store)?;
        let number = view.start + number;
        if number < store.shape.len() { Ok(store.place(view.store, number)) } else { Err(Fault::INDEX_TOO_LARGE) }
    }

    /// Inserts a default value before the one with this index, or behind the last (2.5.4).
    ///
    /// # Errors
    /// 20 and 21 for a bad index, 40 beyond `limit` values, or without memory, 70 for a local array or one of more
    /// dimensions.
    pub fn insert_at(&mut self, view: View, index: f64, limit: Option<u32>) -> Result<()> {
        let store = self.growing(view.store, limit)?;
        let Shape::Array { dims: 1, sizes: [size, ..] } = store.shape else { return Err(Fault::INVALID_PARAMETER) };
        let number = number_within(view, size + 1, index)?;
        let before = store.kind.size * number;
        let (kind, owner) = (store.kind.clone(), store.owner);
        store.shape = Shape::array(size + 1);
        splice(&mut store.nums, before.num, &kind.default.nums);
        splice(&mut store.texts, before.text, &kind.default.texts);
        splice(&mut store.links, before.link, &kind.default.links);
        let parts = self.create_parts(&kind, None, owner);
        splice(&mut self.store_mut(view.store)?.parts, before.part, &parts);
        Ok(())
    }

    /// Inserts a default value under a key; `false` where there is such a key (2.5.4).
    ///
    /// # Errors
    /// 40 beyond `limit` values, or without memory, 70 for an array or an empty key.
    pub fn insert_key(&mut self, id: StoreId, key: Text, limit: Option<u32>) -> Result<bool> {
        let store = self.store(id)?;
        let Shape::Collection(keys) = &store.shape else { return Err(Fault::INVALID_PARAMETER) };
        if keys.contains_key(&key) {
            return Ok(false);
        }
        if key.as_str().is_empty() {
            return Err(Fault::INVALID_PARAMETER);
        }
        let store = self.growing(id, limit)?;
        let gap = store.gaps.pop();
        let number = gap.unwrap_or_else(|| store.shape.len());
        if let Shape::Collection(keys) = &mut store.shape {
            keys.insert(key, number);
        }
        if gap.is_some() {
            self.reset(id, number)?;
        } else {
            self.push(id)?;
        }
        Ok(true)
    }

    /// Adds a default value behind the last one (2.5.5).
    ///
    /// # Errors
    /// 40 beyond `limit` values, or without memory, 70 for a local array or one of more dimensions.
    pub fn append(&mut self, id: StoreId, limit: Option<u32>) -> Result<()> {
        let store = self.growing(id, limit)?;
        let Shape::Array { dims: 1, sizes: [size, ..] } = store.shape else { return Err(Fault::INVALID_PARAMETER) };
        store.shape = Shape::array(size + 1);
        self.push(id)
    }

    /// Takes out the value with this index (2.5.4). An array keeps at least one value.
    ///
    /// # Errors
    /// 20 and 21 for a bad index, 70 for the last value, a local array or one of more dimensions.
    pub fn delete_at(&mut self, view: View, index: f64) -> Result<()> {
        let store = self.changing(view.store)?;
        let Shape::Array { dims: 1, sizes: [size, ..] } = store.shape else { return Err(Fault::INVALID_PARAMETER) };
        let number = store.number1(view, index)?;
        if size == 1 {
            return Err(Fault::INVALID_PARAMETER);
        }
        let (at, one) = (store.kind.size * number, store.kind.size);
        cut(&mut store.nums, at.num, one.num);
        cut(&mut store.texts, at.text, one.text);
        cut(&mut store.links, at.link, one.link);
        let parts = cut(&mut store.parts, at.part, one.part);
        store.shape = Shape::array(size - 1);
        parts.into_iter().for_each(|part| self.remove(part));
        Ok(())
    }

    /// Takes out the value under a key (2.5.4).
    ///
    /// # Errors
    /// 20 if there is no such key, 70 for an array.
    pub fn delete_key(&mut self, id: StoreId, key: &Text) -> Result<()> {
        let store = self.changing(id)?;
        let Shape::Collection(keys) = &mut store.shape else { return Err(Fault::INVALID_PARAMETER) };
        let number = keys.remove(key).ok_or(Fault::INDEX_TOO_LARGE)?;
        store.gaps.push(number);
        Ok(())
    }

    /// Gives a dimension, counted from 1, another size; values keep their indexes (2.5.5). The size is that of the part
    /// which can be reached through the view.
    ///
    /// # Errors
    /// 40 beyond `limit` values, or without memory, 70 for a local array, a collection, a dimension that the array lacks or
    /// a size below 1.
    pub fn resize(&mut self, view: View, dimension: f64, size: f64, limit: Option<u32>) -> Result<()> {
        let store = self.changing(view.store)?;
        let Shape::Array { dims, sizes: old } = store.shape else { return Err(Fault::INVALID_PARAMETER) };
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

    /// Moves the values of an array to their places in one of other sizes.
    fn rearrange(&mut self, id: StoreId, old: [u32; 3], new: [u32; 3], dims: u8) -> Result<()> {
        let source = self.store(id)?.clone();
        let kind = source.kind.clone();
        let shape = Shape::Array { dims, sizes: new };
        let mut target = Store { parts: Vec::new(), ..Store::filled(kind.clone(), shape) };
        let mut kept = vec![false; source.parts.len()];
        let indexes =
            |[x, y, z]: [u32; 3]| (0..x).flat_map(move |i| (0..y).flat_map(move |j| (0..z).map(move |k| [i, j, k])));
        let number = |[i, j, k]: [u32; 3], [_, y, z]: [u32; 3]| (i * y + j) * z + k;
        for at in indexes(new) {
            let was = at.iter().zip(old).all(|(index, size)| *index < size);
            if was {
                let (from, to) = (kind.size * number(at, old), kind.size * number(at, new));
                move_lanes(&source, from, &mut target, to, kind.size);
                let parts = from.part as usize..(from.part + kind.size.part) as usize;
                target.parts.extend_from_slice(source.parts.get(parts.clone()).unwrap_or_default());
                kept.get_mut(parts).unwrap_or_default().fill(true);
            } else if kind.size.part > 0 {
                target.parts.extend(self.create_parts(&kind, None, source.owner));
            }
        }
        let lost: Vec<StoreId> =
            source.parts.iter().zip(kept).filter(|(_, kept)| !kept).map(|(part, _)| *part).collect();
        lost.into_iter().for_each(|part| self.remove(part));
        let Store { nums, texts, links, parts, shape, .. } = target;
        let store = self.store_mut(id)?;
        (store.nums, store.texts, store.links, store.parts, store.shape) = (nums, texts, links, parts, shape);
        Ok(())
    }

    /// The first key of a collection that lies within these bounds.
    ///
    /// # Errors
    /// 70 for an array.
    pub fn key_from(&self, id: StoreId, from: Bound<&Text>) -> Result<Option<Text>> {
        match &self.store(id)?.shape {
            Shape::Collection(keys) => Ok(keys.range((from, Bound::Unbounded)).next().map(|(key, _)| *key)),
            Shape::Array { .. } => Err(Fault::INVALID_PARAMETER),
        }
    }

    /// The last key of a collection that lies within these bounds.
    ///
    /// # Errors
    /// 70 for an array.
    pub fn key_up_to(&self, id: StoreId, to: Bound<&Text>) -> Result<Option<Text>> {
        match &self.store(id)?.shape {
            Shape::Collection(keys) => Ok(keys.range((Bound::Unbounded, to)).next_back().map(|(key, _)| *key)),
            Shape::Array { .. } => Err(Fault::INVALID_PARAMETER),
        }
    }

    /// A container whose size may change.
    fn changing(&mut self, id: StoreId) -> Result<&mut Store> {
        let store = self.store_mut(id)?;
        if store.owner == Owner::Program && !store.field { Err(Fault::INVALID_PARAMETER) } else { Ok(store) }
    }

    /// A container that takes one more value.
    fn growing(&mut self, id: StoreId, limit: Option<u32>) -> Result<&mut Store> {
        let store = self.changing(id)?;
        let most = most_values(store.kind.size, limit);
        if store.shape.len() >= most { Err(Fault::NO_MEMORY) } else { Ok(store) }
    }

    fn push(&mut self, id: StoreId) -> Result<()> {
        let store = self.store_mut(id)?;
        store.push_default();
        let (kind, owner) = (store.kind.clone(), store.owner);
        let parts = self.create_parts(&kind, None, owner);
        self.store_mut(id)?.parts.extend(parts);
        Ok(())
    }
}

/// How many values of this size a variable may have.
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

fn move_lanes(source: &Store, from: Lanes, target: &mut Store, to: Lanes, size: Lanes) {
    fn lane<T: Copy>(source: &[T], from: u32, target: &mut [T], to: u32, size: u32) {
        let range = |at: u32| at as usize..(at + size) as usize;
        if let (Some(source), Some(target)) = (source.get(range(from)), target.get_mut(range(to))) {
            target.copy_from_slice(source);
        }
    }
    lane(&source.nums, from.num, &mut target.nums, to.num, size.num);
    lane(&source.texts, from.text, &mut target.texts, to.text, size.text);
    lane(&source.links, from.link, &mut target.links, to.link, size.link);
}
