//! Numbers of pages and `get` instructions.

use val3_lang::ports::DEFAULT_PAGE;

/// Page: the default page or the page of a `screen` variable.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub struct PageId(u32);

impl PageId {
    /// Page that instructions without a screen use; it always exists (4.2.1).
    pub const DEFAULT: Self = Self(DEFAULT_PAGE);

    /// Number that a variable stores.
    #[must_use]
    pub const fn number(self) -> u32 {
        self.0
    }

    /// Page with the number that a variable stores.
    #[must_use]
    pub const fn from_number(number: u32) -> Self {
        Self(number)
    }
}

/// Waiting `get`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ReadingId(u64);

impl ReadingId {
    /// `get` with this number in the order of starting.
    pub(super) const fn from_number(number: u64) -> Self {
        Self(number)
    }
}
