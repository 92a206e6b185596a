//! Numbers of lanes, and lane offsets.

use std::ops::{Add, Mul, Sub};

use super::{LinkPlace, StoreId, bytes_of};
use crate::values::Text;

/// Lane counts by sort, or lane offsets by sort.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Hash)]
pub struct Lanes {
    /// Numbers, truth values, enumerators.
    pub num: u32,
    /// Strings.
    pub text: u32,
    /// Links.
    pub link: u32,
    /// Inner containers.
    pub part: u32,
}

impl Lanes {
    /// Size of these lanes in bytes.
    #[must_use]
    pub fn bytes(self) -> u64 {
        bytes_of::<f64>(self.num as usize)
            + bytes_of::<Text>(self.text as usize)
            + bytes_of::<LinkPlace>(self.link as usize)
            + bytes_of::<StoreId>(self.part as usize)
    }

    /// Creates lanes with only numbers.
    #[must_use]
    pub const fn nums(num: u32) -> Self {
        Self { num, text: 0, link: 0, part: 0 }
    }

    /// Creates lanes with only strings.
    #[must_use]
    pub const fn texts(text: u32) -> Self {
        Self { num: 0, text, link: 0, part: 0 }
    }
}

impl Add for Lanes {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            num: self.num + other.num,
            text: self.text + other.text,
            link: self.link + other.link,
            part: self.part + other.part,
        }
    }
}

/// Offset from `other`, 0 if these lanes are before it.
impl Sub for Lanes {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self {
            num: self.num.saturating_sub(other.num),
            text: self.text.saturating_sub(other.text),
            link: self.link.saturating_sub(other.link),
            part: self.part.saturating_sub(other.part),
        }
    }
}

/// Lanes of consecutive values.
impl Mul<u32> for Lanes {
    type Output = Self;

    fn mul(self, count: u32) -> Self {
        Self { num: self.num * count, text: self.text * count, link: self.link * count, part: self.part * count }
    }
}
