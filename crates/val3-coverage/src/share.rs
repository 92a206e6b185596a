//! Share of executed items, such as the executed lines of a program.

use std::fmt;
use std::iter::Sum;
use std::ops::Add;

/// Number of executed items, and of all items.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Share {
    /// Number of executed items.
    pub hit: u64,
    /// Number of all items.
    pub total: u64,
}

impl Share {
    /// Returns the share of counts greater than 0.
    pub fn of(counts: impl IntoIterator<Item = u64>) -> Self {
        counts.into_iter().map(|count| Self { hit: u64::from(count > 0), total: 1 }).sum()
    }

    /// Returns the share in per cent; 100 if there are no items.
    #[must_use]
    pub fn percent(self) -> f64 {
        100.0 * self.rate()
    }

    /// Returns the share as a number from 0 to 1; 1 if there are no items.
    #[must_use]
    #[allow(clippy::cast_precision_loss, reason = "programs have fewer lines than numbers are exact")]
    pub fn rate(self) -> f64 {
        if self.total == 0 { 1.0 } else { self.hit as f64 / self.total as f64 }
    }
}

impl Add for Share {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self { hit: self.hit + other.hit, total: self.total + other.total }
    }
}

impl Sum for Share {
    fn sum<I: Iterator<Item = Self>>(shares: I) -> Self {
        shares.fold(Self::default(), Add::add)
    }
}

/// Formats per cent with one decimal, rounded down, so that 100.0 % means complete coverage.
impl fmt::Display for Share {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let permille = self.hit.saturating_mul(1000).checked_div(self.total).unwrap_or(1000);
        f.pad(&format!("{}.{} %", permille / 10, permille % 10))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_share_is_rounded_down() {
        let shown = |hit, total| Share { hit, total }.to_string();
        assert_eq!(
            [shown(1999, 2000), shown(2, 3), shown(0, 7), shown(0, 0)],
            ["99.9 %", "66.6 %", "0.0 %", "100.0 %"]
        );
        assert_eq!(Share::of([0, 3, 1, 0]), Share { hit: 2, total: 4 });
    }
}
