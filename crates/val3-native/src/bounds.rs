//! Between which numbers a whole number surely is: what needs no check.

use std::collections::BTreeMap;
use std::ops::{Add, Mul, Sub};

use val3_bytecode::{Op, Program, Register};

use crate::lanes::{Lane, Lanes, number};
use crate::operands::written;

/// The least and the largest number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Bounds {
    least: i64,
    most: i64,
}

impl Bounds {
    /// Whole numbers that are exact, as are their neighbours.
    pub(crate) const EXACT: Self = Self { least: 1 - (1 << 53), most: (1 << 53) - 1 };

    /// Indexes.
    pub(crate) const INDEXES: Self = Self { least: 0, most: u32::MAX as i64 };

    /// Of one number; `None` unless it is whole and [`EXACT`](Self::EXACT). The negative zero is none.
    pub(crate) fn of(number: f64) -> Option<Self> {
        #[expect(clippy::cast_possible_truncation, reason = "what does not fit becomes another number")]
        let whole = number as i64;
        #[expect(clippy::cast_precision_loss, reason = "what is not exact becomes another number")]
        let is_whole = (whole as f64).to_bits() == number.to_bits();
        Some(Self { least: whole, most: whole }).filter(|bounds| is_whole && bounds.are_exact())
    }

    /// Whether all numbers between are exact.
    pub(crate) fn are_exact(self) -> bool {
        Self::EXACT.least <= self.least && self.most <= Self::EXACT.most
    }

    /// The largest number.
    pub(crate) fn most(self) -> i64 {
        self.most
    }

    /// Whether no number is negative.
    pub(crate) fn are_positive(self) -> bool {
        self.least >= 0
    }

    /// The numbers that are between both.
    pub(crate) fn and(self, other: Self) -> Self {
        Self { least: self.least.max(other.least), most: self.most.min(other.most) }
    }

    /// The numbers between either, and those between them.
    fn or(self, other: Self) -> Self {
        Self { least: self.least.min(other.least), most: self.most.max(other.most) }
    }
}

impl Add for Bounds {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self { least: self.least.saturating_add(other.least), most: self.most.saturating_add(other.most) }
    }
}

impl Sub for Bounds {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self { least: self.least.saturating_sub(other.most), most: self.most.saturating_sub(other.least) }
    }
}

impl Mul for Bounds {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let ends =
            [(self.least, other.least), (self.least, other.most), (self.most, other.least), (self.most, other.most)];
        let products = ends.map(|(a, b)| a.saturating_mul(b));
        let of = |product| Self { least: product, most: product };
        products.into_iter().map(of).fold(of(products[0]), Self::or)
    }
}

/// The bounds of a whole number wherever the program is: where it only becomes constants, and counts up to one.
pub(crate) fn everywhere(program: &Program, lanes: &Lanes, register: Register) -> Bounds {
    let constant = |register| match lanes.get(register) {
        Lane::Constant(value) => Bounds::of(value),
        _ => None,
    };
    let ops = || program.code.iter().map(|step| step.op).filter(|op| written(*op) == Some(register));
    let begin = Bounds::of(number(program, register).unwrap_or_default());
    let becomes = |bounds: Option<Bounds>, op| match op {
        Op::Move { from, .. } => Some(bounds?.or(constant(from)?)),
        Op::ForNextUp { limit, .. } => Some(bounds?.or(constant(limit)?)),
        _ => None,
    };
    let counted = |bounds: Option<Bounds>, op| match op {
        Op::ForNextUp { limit, .. } => bounds.map(|bounds| Some(bounds.or(bounds + constant(limit + 1)?)))?,
        _ => bounds,
    };
    let all = ops().fold(ops().fold(begin, becomes), counted);
    all.filter(|bounds| bounds.are_exact()).unwrap_or(Bounds::EXACT)
}

/// What is known of whole numbers between two jumps that lead in.
pub(crate) type Facts = BTreeMap<Register, Bounds>;

#[cfg(test)]
mod tests {
    use super::Bounds;

    #[test]
    fn results_are_within_the_bounds_of_the_operation() {
        let ends = [-9_007_199_254_740_991_i64, -3, -1, 0, 1, 2, 5, 9_007_199_254_740_991];
        let bounds = || {
            let pairs = ends.iter().flat_map(|least| ends.iter().map(|most| (*least, *most)));
            pairs.filter(|(least, most)| least <= most).map(|(least, most)| Bounds { least, most })
        };
        for (a, b) in bounds().flat_map(|a| bounds().map(move |b| (a, b))) {
            let members = |of: Bounds| ends.into_iter().filter(move |end| (of.least..=of.most).contains(end));
            for (x, y) in members(a).flat_map(|x| members(b).map(move |y| (x, y))) {
                let holds = |bounds: Bounds, result: i64| (bounds.least..=bounds.most).contains(&result);
                assert!(holds(a + b, x + y), "{x} + {y} in {:?}", a + b);
                assert!(holds(a - b, x - y), "{x} - {y} in {:?}", a - b);
                assert!(holds(a * b, x.saturating_mul(y)), "{x} * {y} in {:?}", a * b);
            }
        }
    }

    #[test]
    fn whole_numbers_are_exact() {
        for number in [0.0, -1.0, 9_007_199_254_740_991.0, -9_007_199_254_740_991.0] {
            assert!(Bounds::of(number).is_some_and(Bounds::are_exact), "{number}");
        }
        for number in [-0.0, 0.5, 9_007_199_254_740_992.0, 1e300, f64::INFINITY, f64::NAN, f64::MIN_POSITIVE] {
            assert_eq!(Bounds::of(number), None, "{number}");
        }
    }
}
