//! Memory limit of programs.

use crate::fault::{Fault, Result};

/// Memory for all data, code, stacks and tasks of a controller, in bytes.
///
/// Controllers have some hundred megabytes. Exceeding the limit is run-time error 40.
pub const MEMORY: u64 = 512 << 20;

/// Used memory of a controller.
///
/// Only values are counted, without the reserved capacity of vectors.
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
    /// Sets a limit that differs from [`MEMORY`].
    pub fn limit_to(&mut self, bytes: u64) {
        self.limit = bytes;
    }

    /// Used memory, in bytes.
    #[must_use]
    pub fn taken(&self) -> u64 {
        self.taken
    }

    /// Checks that enough memory is free.
    ///
    /// # Errors
    /// 40 if fewer bytes are free.
    #[inline]
    pub fn check(&self, bytes: u64) -> Result<()> {
        if self.taken.saturating_add(bytes) > self.limit { Err(Fault::NO_MEMORY) } else { Ok(()) }
    }

    /// Allocates memory.
    ///
    /// # Errors
    /// 40 if fewer bytes are free.
    #[inline]
    pub fn take(&mut self, bytes: u64) -> Result<()> {
        self.check(bytes)?;
        self.taken += bytes;
        Ok(())
    }

    /// Counts memory that is already in use, even beyond the limit.
    pub fn count(&mut self, bytes: u64) {
        self.taken = self.taken.saturating_add(bytes);
    }

    /// Releases allocated memory.
    #[inline]
    pub fn give_back(&mut self, bytes: u64) {
        self.taken = self.taken.saturating_sub(bytes);
    }
}

/// Size of `count` values of type `T`, in bytes.
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
