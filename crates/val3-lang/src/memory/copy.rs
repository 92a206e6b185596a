//! New containers, and copies of values.

use super::{Element, Kind, Lanes, Memory, Owner, PartInit, Place, Shape, Store, StoreId};
use crate::fault::{Fault, Result};

impl Memory {
    /// A new container with these values: global data of the application.
    ///
    /// # Errors
    /// 40 without memory.
    pub fn create(&mut self, init: &PartInit) -> Result<StoreId> {
        self.create_for(Owner::APPLICATION, init)
    }

    /// A new container with these values, which ends with a program.
    ///
    /// # Errors
    /// 40 without memory.
    pub fn create_local(&mut self, init: &PartInit) -> Result<StoreId> {
        self.create_for(Owner::Program, init)
    }

    /// A new container with these values.
    ///
    /// # Errors
    /// 40 without memory.
    pub fn create_for(&mut self, owner: Owner, init: &PartInit) -> Result<StoreId> {
        self.create_as(init, owner, false)
    }

    /// Makes one container of each of `sources`; none if one of them cannot be made.
    ///
    /// # Errors
    /// That of the first that cannot be made.
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

    /// The containers of values of a user type; those of a value that is `None` are as the type has them.
    pub(super) fn create_parts<'v>(
        &mut self,
        kind: &Kind,
        values: impl IntoIterator<Item = Option<&'v Element>>,
        owner: Owner,
    ) -> Result<Vec<StoreId>> {
        let parts = |value: Option<&'v Element>| value.map(|value| &value.parts).filter(|parts| !parts.is_empty());
        let parts = values.into_iter().flat_map(|value| parts(value).unwrap_or(&kind.default.parts));
        self.create_all(parts, |memory, part| memory.create_as(part, owner, true))
    }

    /// Copies a value of the type `kind`: `to = from` (2.3, 7.3). The fields of a user type get as many values as
    /// those that are copied.
    ///
    /// # Errors
    /// 20 if one of the values is gone, 82 and 165 if a link is none that `to` may have, 40 without memory.
    pub fn copy(&mut self, kind: &Kind, from: Place, to: Place) -> Result<()> {
        let Lanes { num, text, link, part } = kind.size;
        // First, because it can be refused.
        (0..link).try_for_each(|lane| self.link(from, lane).and_then(|value| self.set_link(to, lane, value)))?;
        self.copy_nums(from, to, num)?;
        for lane in 0..text {
            let lane = Lanes { text: lane, ..Lanes::default() };
            let value = *self.text(from.after(lane))?;
            self.set_text(to.after(lane), value)?;
        }
        (0..part).try_for_each(|lane| {
            let (from, to) = (self.part(from, lane)?, self.part(to, lane)?);
            self.copy_store(from, to)
        })
    }

    /// Copies numbers. A single one and those of a structure are looked up once.
    #[inline]
    fn copy_nums(&mut self, from: Place, to: Place, count: u32) -> Result<()> {
        match count {
            0 => Ok(()),
            1 => self.set_num(to, 0, self.num(from, 0)?),
            // Transformations and joints; points.
            6 => self.set_nums(to, 0, self.nums::<6>(from, 0)?),
            9 => self.set_nums(to, 0, self.nums::<9>(from, 0)?),
            _ => (0..count).try_for_each(|lane| self.set_num(to, lane, self.num(from, lane)?)),
        }
    }

    /// Makes the container `to` hold what `from` holds.
    fn copy_store(&mut self, from: StoreId, to: StoreId) -> Result<()> {
        if from == to {
            return Ok(());
        }
        // Without new containers, a copy of a user type takes a tenth of the time.
        let (source, owner) = (self.store(from)?, self.owner(to));
        source.links.iter().try_for_each(|link| self.check_link(owner, *link))?;
        if self.stores.overwrite(to, from)? {
            return Ok(());
        }
        let copy = self.duplicate(from, owner)?;
        self.stores.exchange(to, copy)?;
        self.remove(copy);
        Ok(())
    }

    /// A copy of a container for an owner.
    fn duplicate(&mut self, id: StoreId, owner: Owner) -> Result<StoreId> {
        let source = self.store(id)?;
        self.stores.room.check(source.bytes())?;
        source.links.iter().try_for_each(|link| self.check_link(owner, *link))?;
        let mut copy = Store { owner, ..source.clone() };
        copy.parts = self.create_all(copy.parts, |memory, part| memory.duplicate(part, owner))?;
        self.add(copy)
    }

    /// Whether two values of one type are equal, field by field, containers of a user type with their indexes and
    /// keys; links do not count.
    ///
    /// # Errors
    /// 20 if one of the values is gone.
    pub fn equal(&self, kind: &Kind, a: Place, b: Place) -> Result<bool> {
        let Lanes { num, text, part, .. } = kind.size;
        for lane in 0..num {
            if self.num(a, lane)? != self.num(b, lane)? {
                return Ok(false);
            }
        }
        for lane in 0..text {
            let lane = Lanes { text: lane, ..Lanes::default() };
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
            (Shape::Array { sizes, .. }, Shape::Array { sizes: others, .. }) if sizes == others => {
                (0..left.shape.len()).map(|number| (number, number)).collect()
            }
            (Shape::Collection(keys), Shape::Collection(others)) if keys.keys().eq(others.keys()) => {
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

    /// Gives a value of a container its default again.
    ///
    /// # Errors
    /// 20 if the container is gone, 40 without memory.
    pub(super) fn reset(&mut self, id: StoreId, number: u32) -> Result<()> {
        let (kind, owner) = (self.store(id)?.kind.clone(), self.owner(id));
        write_lanes(self.store_mut(id)?, number, &kind.default);
        for lane in 0..kind.size.part {
            let part = self.part(Place::new(id, kind.size * number), lane)?;
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

/// Writes numbers, texts and links of one value.
fn write_lanes(store: &mut Store, number: u32, value: &Element) {
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
