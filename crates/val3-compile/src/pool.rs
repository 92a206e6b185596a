//! Registers of the same kind, reserved and released in runs.

use crate::error::{CompileLimit, Result};

/// Registers of the same kind.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Pool {
    /// Number of registers.
    size: u32,
    /// Free runs: start and length, in ascending order and not adjacent.
    free: Vec<(u32, u32)>,
}

impl Pool {
    /// Creates a pool whose first registers, of this number, are in use elsewhere.
    pub(crate) fn after(size: u32) -> Self {
        Self { size, free: Vec::new() }
    }

    /// Returns the number of registers.
    pub(crate) fn size(&self) -> u32 {
        self.size
    }

    /// Reserves `count` consecutive registers, and returns the first one.
    pub(crate) fn take(&mut self, count: u32) -> Result<u32> {
        if count == 0 {
            return Ok(0);
        }
        let Some(at) = self.free.iter().position(|(_, length)| *length >= count) else { return self.grow(count) };
        let (start, length) = self.free.remove(at);
        if length > count {
            self.free.insert(at, (start + count, length - count));
        }
        Ok(start)
    }

    /// Reserves `count` consecutive registers that were never reserved before.
    pub(crate) fn grow(&mut self, count: u32) -> Result<u32> {
        let start = self.size;
        self.size = start + count;
        if self.size > u32::from(u16::MAX) { Err(CompileLimit::Registers) } else { Ok(start) }
    }

    /// Releases a run of registers.
    pub(crate) fn give(&mut self, start: u32, count: u32) {
        if count == 0 {
            return;
        }
        let at = self.free.partition_point(|(other, _)| *other < start);
        self.free.insert(at, (start, count));
        self.free.dedup_by(|next, run| {
            let adjacent = run.0 + run.1 == next.0;
            run.1 += if adjacent { next.1 } else { 0 };
            adjacent
        });
    }
}

#[cfg(test)]
mod tests {
    use super::{CompileLimit, Pool};

    #[test]
    fn runs_are_taken_again() {
        let mut pool = Pool::default();
        let [a, b, c] = [1, 6, 2].map(|count| pool.take(count).unwrap());
        assert_eq!((a, b, c), (0, 1, 7));
        pool.give(c, 2);
        pool.give(a, 1);
        pool.give(b, 6);
        assert_eq!(pool.take(9), Ok(0));
        assert_eq!(pool.take(1), Ok(9));
    }

    #[test]
    fn there_is_a_limit() {
        let mut pool = Pool::default();
        assert_eq!(pool.take(65_535), Ok(0));
        assert_eq!(pool.take(1), Err(CompileLimit::Registers));
    }
}
