//! Assignment of containers: the fields of user types (7.3).
//!
//! The target gets the size or the keys of the source. Elements that exist before and after the assignment keep their
//! addresses, so references to them, and to fields in them, stay valid.

use super::{ContainerShape, Memory, Owner, StoreId};
use crate::fault::{Fault, Result};

impl Memory {
    /// Copies the content of container `from` to container `to`.
    ///
    /// # Errors
    /// 20 if one of them does not exist, 82 and 165 if `to` may not have a link, 40 without memory.
    pub(super) fn assign_container(&mut self, from: StoreId, to: StoreId) -> Result<()> {
        if from == to {
            return Ok(());
        }
        self.check_links(from, self.owner(to))?;
        self.assign(from, to)
    }

    /// Checks that an owner may have the links in a container and its inner containers. The inner containers of deleted
    /// values do not exist.
    fn check_links(&self, id: StoreId, owner: Owner) -> Result<()> {
        let store = self.store(id)?;
        store.links.iter().try_for_each(|link| self.check_link(owner, *link))?;
        let mut parts = store.parts.iter().filter(|part| self.store(**part).is_ok());
        parts.try_for_each(|part| self.check_links(*part, owner))
    }

    fn assign(&mut self, from: StoreId, to: StoreId) -> Result<()> {
        // Overwriting existing values is ten times as fast as other ways.
        if self.stores.overwrite(to, from)? || self.replace_values(from, to)? {
            return Ok(());
        }
        match self.store(from)?.shape.clone() {
            ContainerShape::Array { dims, sizes } => self.assign_array(from, to, sizes, dims),
            ContainerShape::Collection(_) => self.assign_collection(from, to),
        }
    }

    /// Replaces all values by a copy, if no address becomes wrong: in arrays without inner containers, and in such
    /// collections that are empty or have the same keys at the same lanes. Otherwise returns `false` without a change.
    fn replace_values(&mut self, from: StoreId, to: StoreId) -> Result<bool> {
        let (source, target) = (self.store(from)?, self.store(to)?);
        let keeps_addresses = match (&source.shape, &target.shape) {
            (ContainerShape::Array { .. }, ContainerShape::Array { .. }) => true,
            (keys, ContainerShape::Collection(others)) => others.is_empty() || *keys == target.shape,
            _ => false,
        };
        if !keeps_addresses || !source.parts.is_empty() || !target.parts.is_empty() {
            return Ok(false);
        }
        let (before, after) = (target.bytes(), source.bytes());
        self.stores.room.check(after.saturating_sub(before))?;
        let mut content = source.clone();
        self.stores.room.take(after.saturating_sub(before))?;
        self.stores.room.give_back(before.saturating_sub(after));
        let target = self.store_mut(to)?;
        target.exchange(&mut content);
        if let (ContainerShape::Array { sizes: old, .. }, ContainerShape::Array { sizes: new, .. }) =
            (content.shape, &target.shape)
        {
            target.note_sizes(old, *new);
        }
        Ok(true)
    }

    fn assign_array(&mut self, from: StoreId, to: StoreId, sizes: [u32; 3], dims: u8) -> Result<()> {
        let ContainerShape::Array { sizes: old, .. } = self.store(to)?.shape else { return Err(Fault::INTERPRETER) };
        if old != sizes {
            self.rearrange(to, old, sizes, dims)?;
        }
        let pairs = self.store(from)?.parts.iter().copied().zip(self.store(to)?.parts.iter().copied());
        let pairs: Vec<(StoreId, StoreId)> = pairs.collect();
        pairs.into_iter().try_for_each(|(from, to)| self.assign(from, to))
    }

    fn assign_collection(&mut self, from: StoreId, to: StoreId) -> Result<()> {
        let (ContainerShape::Collection(new), ContainerShape::Collection(old)) =
            (self.store(from)?.shape.clone(), self.store(to)?.shape.clone())
        else {
            return Err(Fault::INTERPRETER);
        };
        let removed = old.keys().filter(|key| !new.contains_key(*key));
        removed.into_iter().try_for_each(|key| self.delete_key(to, key))?;
        let kind = self.store(from)?.kind.clone();
        for (key, number) in new {
            self.insert_key(to, key, None)?;
            let target = self.store(to)?;
            let (from, to) = (self.store(from)?.place(from, number), target.place(to, target.number_of(&key)?));
            self.copy(&kind, from, to)?;
        }
        Ok(())
    }
}
