//! A part of a whole, such as the executed lines of a program.

use std::fmt;
use std::iter::Sum;
use std::ops::Add;

/// The number of executed items, and of all items.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Share {
    /// Those that were executed.
    pub hit: u64,
    /// All of them.
    pub total: u64,
}

impl Share {
    /// The share of the counts that are not 0.
    pub fn of(counts: impl IntoIterator<Item = u64>) -> Self {
        counts.into_iter().map(|count| Self { hit: u64::from(count > 0), total: 1 }).sum()
    }

    /// The share in per cent; 100 if there are no items.
    #[must_use]
    pub fn percent(self) -> f64 {
        100.0 * self.rate()
    }

    /// From 0 to 1.
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

/// Per cent with one decimal, rounded down: 100.0 % is complete.
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
