//! Numbers by which machine code counts: the lines that are left, and rounds.
//!
//! They are in memory, though they never change. A sum with a constant the engine computes anew wherever somebody asks
//! for it, and so keeps the number from before as well; in a loop, that is one more number in registers, and one more to
//! be copied at the end of each round. What it has read, it adds once.

use crate::body::{Body, bytes_behind, whole_at};
use crate::exchange::write;
use crate::layout::{ONE, SMALL, SMALL_NUMBERS};

/// Writes the numbers where machine code reads them; `None` if the memory is too small.
pub(crate) fn write_numbers(bytes: &mut [u8]) -> Option<()> {
    write(bytes, ONE, &1_u64.to_le_bytes())?;
    (0..SMALL_NUMBERS).try_for_each(|number| write(bytes, SMALL + number * 4, &number.to_le_bytes()))
}

impl Body<'_> {
    /// A number of lines.
    pub(crate) fn lines(&mut self, count: u32) {
        if count < SMALL_NUMBERS {
            self.code().i32_const(0).i32_load(whole_at(SMALL + count * 4));
        } else {
            self.code().i32_const(count.cast_signed());
        }
    }

    /// A round.
    pub(crate) fn one(&mut self) {
        self.code().i32_const(0).i64_load(bytes_behind(ONE));
    }
}
