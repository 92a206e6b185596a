//! Creates containers, and copies values.

use super::{ContainerShape, DetachedValue, Lanes, Memory, Owner, PartInit, Place, Store, StoreId, ValueType};
use crate::fault::{Fault, Result};

impl Memory {
    /// Creates a container with these values, as global data of the application.
    ///
    /// # Errors
    /// 40 without memory.
    pub fn create(&mut self, init: &PartInit) -> Result<StoreId> {
        self.create_for(Owner::APPLICATION, init)
    }

    /// Creates a container with these values, which is removed at the end of a program.
    ///
    /// # Errors
    /// 40 without memory.
    pub fn create_local(&mut self, init: &PartInit) -> Result<StoreId> {
        self.create_for(Owner::Program, init)
    }

    /// Creates a container with these values.
    ///
    /// # Errors
    /// 40 without memory.
    pub fn create_for(&mut self, owner: Owner, init: &PartInit) -> Result<StoreId> {
        self.create_as(init, owner, false)
    }

    /// Creates one container for each of `sources`; none if one of them cannot be created.
    ///
    /// # Errors
    /// The error of the first container that cannot be created.
    pub fn create_all<T>(
        &mut self,
        sources: impl IntoIterator<Item = T>,
        mut create: impl FnMut(&mut Self, T) -> Result<StoreId>,
    ) -> Result<Vec<StoreId>> {
        let mut created = Vec::new();
        for source in sources {
            match create(self, source) {
                Ok(id) => created.push(id),
                Err(fault) => {
                    created.into_iter().for_each(|id| self.remove(id));
                    return Err(fault);
                }
            }
        }
        Ok(created)
    }

    fn create_as(&mut self, init: &PartInit, owner: Owner, field: bool) -> Result<StoreId> {
        self.stores.room.check(init.shape.bytes(init.kind.size))?;
        let mut store = Store { owner, field, ..Store::filled(init.kind.clone(), init.shape.clone()) };
        let count = init.shape.len();
        for (number, value) in (0..count).zip(&init.values) {
            if let Some(value) = value {
                write_lanes(&mut store, number, value);
            }
        }
        if init.kind.size.part > 0 {
            let values = init.values.iter().map(Option::as_ref).chain(std::iter::repeat(None));
            store.parts = self.create_parts(&init.kind, values.take(count as usize), owner)?;
        }
        self.add(store)
    }

    /// Creates the inner containers of user type values. `None` means the type's default value.
    pub(super) fn create_parts<'v>(
        &mut self,
        kind: &ValueType,
        values: impl IntoIterator<Item = Option<&'v DetachedValue>>,
        owner: Owner,
    ) -> Result<Vec<StoreId>> {
        let parts = values.into_iter().flat_map(|value| {
            let own = value.map(|value| &value.parts).filter(|parts| !parts.is_empty());
            own.unwrap_or(&kind.default.parts)
        });
        self.create_all(parts, |memory, part| memory.create_as(part, owner, true))
    }

    /// Copies a value of the type `kind`: `to = from` (2.3, 7.3). The fields of a user type get the size of the
    /// source's fields.
    ///
    /// # Errors
    /// 20 if one of the values does not exist, 82 and 165 if `to` may not have a link, 40 without memory.
    pub fn copy(&mut self, kind: &ValueType, from: Place, to: Place) -> Result<()> {
        let Lanes { num, text, link, part } = kind.size;
        // Links first, because they can be rejected.
        (0..link).try_for_each(|lane| self.link(from, lane).and_then(|value| self.set_link(to, lane, value)))?;
        self.copy_nums(from, to, num)?;
        for lane in 0..text {
            let lane = Lanes::texts(lane);
            let value = *self.text(from.after(lane))?;
            self.set_text(to.after(lane), value)?;
        }
        (0..part).try_for_each(|lane| {
            let (from, to) = (self.part(from, lane)?, self.part(to, lane)?);
            self.assign_container(from, to)
        })
    }

    /// Copies numbers. Single numbers and structures require only one lookup.
    #[inline]
    fn copy_nums(&mut self, from: Place, to: Place, count: u32) -> Result<()> {
        match count {
            0 => Ok(()),
            1 => self.set_num(to, 0, self.num(from, 0)?),
            // 6: transformations and joints; 9: points.
            6 => self.set_nums(to, 0, self.nums::<6>(from, 0)?),
            9 => self.set_nums(to, 0, self.nums::<9>(from, 0)?),
            _ => (0..count).try_for_each(|lane| self.set_num(to, lane, self.num(from, lane)?)),
        }
    }

    /// Whether two values of one type are equal in all fields. Containers of a user type are compared with their
    /// indexes and keys. Links are ignored.
    ///
    /// # Errors
    /// 20 if one of the values does not exist.
    pub fn equal(&self, kind: &ValueType, a: Place, b: Place) -> Result<bool> {
        let Lanes { num, text, part, .. } = kind.size;
        for lane in 0..num {
            if self.num(a, lane)? != self.num(b, lane)? {
                return Ok(false);
            }
        }
        for lane in 0..text {
            let lane = Lanes::texts(lane);
            if self.text(a.after(lane))? != self.text(b.after(lane))? {
                return Ok(false);
            }
        }
        for lane in 0..part {
            if !self.equal_stores(self.part(a, lane)?, self.part(b, lane)?)? {
                return Ok(false);
            }
        }
        Ok(true)
    }

    fn equal_stores(&self, a: StoreId, b: StoreId) -> Result<bool> {
        let (left, right) = (self.store(a)?, self.store(b)?);
        let numbers: Vec<(u32, u32)> = match (&left.shape, &right.shape) {
            (ContainerShape::Array { sizes, .. }, ContainerShape::Array { sizes: others, .. }) if sizes == others => {
                (0..left.shape.len()).map(|number| (number, number)).collect()
            }
            (ContainerShape::Collection(keys), ContainerShape::Collection(others)) if keys.keys().eq(others.keys()) => {
                keys.values().copied().zip(others.values().copied()).collect()
            }
            _ => return Ok(false),
        };
        for (at, other) in numbers {
            if !self.equal(&left.kind, left.place(a, at), right.place(b, other))? {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// Resets an element to its default value.
    ///
    /// # Errors
    /// 20 if the container does not exist, 40 without memory.
    pub(super) fn reset(&mut self, id: StoreId, number: u32) -> Result<()> {
        let (kind, owner) = (self.store(id)?.kind.clone(), self.owner(id));
        write_lanes(self.store_mut(id)?, number, &kind.default);
        for lane in 0..kind.size.part {
            let part = self.part(self.store(id)?.place(id, number), lane)?;
            let init = kind.default.parts.get(lane as usize).ok_or(Fault::INTERPRETER)?;
            let fresh = self.create_as(init, owner, true)?;
            let at = (kind.size.part * number + lane) as usize;
            if let Some(slot) = self.store_mut(id)?.parts.get_mut(at) {
                *slot = fresh;
            }
            self.remove(part);
        }
        Ok(())
    }
}

impl Store {
    /// Makes a gap of a collection's value: resets its lanes, so that it keeps no links, and makes its addresses
    /// invalid. Returns its inner containers.
    pub(super) fn clear_value(&mut self, number: u32) -> Vec<StoreId> {
        let kind = self.kind.clone();
        write_lanes(self, number, &kind.default);
        self.gaps.push(number);
        self.note_removal(number);
        let (first, count) = ((kind.size.part * number) as usize, kind.size.part as usize);
        self.parts.iter().skip(first).take(count).copied().collect()
    }
}

/// Writes a value's numbers, strings and links.
fn write_lanes(store: &mut Store, number: u32, value: &DetachedValue) {
    let at = store.kind.size * number;
    write(&mut store.nums, at.num, &value.nums);
    write(&mut store.texts, at.text, &value.texts);
    write(&mut store.links, at.link, &value.links);
}

fn write<T: Copy>(lanes: &mut [T], at: u32, values: &[T]) {
    let at = at as usize;
    if let Some(found) = lanes.get_mut(at..at + values.len()) {
        found.copy_from_slice(values);
    }
}
