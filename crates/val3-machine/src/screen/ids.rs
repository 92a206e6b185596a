//! Numbers of pages and of `get` instructions.

use val3_lang::ports::DEFAULT_PAGE;

/// A page: the default one or that of a `screen` variable.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub struct PageId(u32);

impl PageId {
    /// The page that instructions without a screen use; it always exists (4.2.1).
    pub const DEFAULT: Self = Self(DEFAULT_PAGE);

    /// The number that a variable keeps.
    #[must_use]
    pub const fn number(self) -> u32 {
        self.0
    }

    /// The page whose number a variable keeps.
    #[must_use]
    pub const fn from_number(number: u32) -> Self {
        Self(number)
    }
}

/// A `get` under way.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ReadingId(u64);

impl ReadingId {
    /// The `get` with this number in the order of their beginning.
    pub(super) const fn from_number(number: u64) -> Self {
        Self(number)
    }
}
