//! How much memory programs may take.

use crate::fault::{Fault, Result};

/// Bytes for all data, code, stacks and tasks of a controller together.
///
/// Controllers have some hundred megabytes. Exceeding them is run-time error 40.
pub const MEMORY: u64 = 512 << 20;

/// The memory of a controller: how much of it is taken.
///
/// Sizes are those of the values. The room that vectors hold in reserve is not counted.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct MemoryBudget {
    taken: u64,
    limit: u64,
}

impl Default for MemoryBudget {
    fn default() -> Self {
        Self { taken: 0, limit: MEMORY }
    }
}

impl MemoryBudget {
    /// Lets the controller have another amount of memory than [`MEMORY`].
    pub fn limit_to(&mut self, bytes: u64) {
        self.limit = bytes;
    }

    /// The bytes that are taken.
    #[must_use]
    pub fn taken(&self) -> u64 {
        self.taken
    }

    /// So many bytes are free.
    ///
    /// # Errors
    /// 40 if they are not.
    #[inline]
    pub fn check(&self, bytes: u64) -> Result<()> {
        if self.taken.saturating_add(bytes) > self.limit { Err(Fault::NO_MEMORY) } else { Ok(()) }
    }

    /// Takes bytes.
    ///
    /// # Errors
    /// 40 if fewer are free.
    #[inline]
    pub fn take(&mut self, bytes: u64) -> Result<()> {
        self.check(bytes)?;
        self.taken += bytes;
        Ok(())
    }

    /// Counts bytes that are in use already, however many are free.
    pub fn count(&mut self, bytes: u64) {
        self.taken = self.taken.saturating_add(bytes);
    }

    /// Gives bytes back that were taken.
    #[inline]
    pub fn give_back(&mut self, bytes: u64) {
        self.taken = self.taken.saturating_sub(bytes);
    }
}

/// The bytes of `count` values of type `T`.
#[inline]
#[must_use]
pub const fn bytes_of<T>(count: usize) -> u64 {
    (count as u64).saturating_mul(size_of::<T>() as u64)
}

#[cfg(test)]
mod tests {
    use super::{MEMORY, MemoryBudget};
    use crate::fault::Fault;

    #[test]
    fn taken_memory_can_be_returned() {
        let mut room = MemoryBudget::default();
        assert_eq!((room.take(MEMORY - 1), room.take(2)), (Ok(()), Err(Fault::NO_MEMORY)));
        room.give_back(MEMORY - 1);
        assert_eq!((room.take(MEMORY), room.check(0), room.check(1)), (Ok(()), Ok(()), Err(Fault::NO_MEMORY)));
        assert_eq!(room.take(u64::MAX), Err(Fault::NO_MEMORY));
    }
}
