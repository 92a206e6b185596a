//! Limits for tasks on the controller (5.5, 5.10).

use crate::arguments::{ArgumentRange, range};
use crate::versions::Version;

/// Unit of periods in seconds; the controller rounds a period down to a multiple of it.
pub const PERIOD_STEP: f64 = 0.004;

/// Maximum number of different periods of synchronous tasks at one time. One more is run-time error 32.
pub const MAX_PERIODS: usize = 2;

/// Valid number of lines that a task executes in its turn.
#[must_use]
pub fn priority() -> Option<&'static ArgumentRange> {
    range("taskCreate", "nPriority")
}

/// Valid time between two turns of a synchronous task, in seconds.
#[must_use]
pub fn period() -> Option<&'static ArgumentRange> {
    range("taskCreateSync", "nPeriod")
}

/// Whether the period is a multiple of the controller's unit, up to the rounding of decimal fractions.
#[must_use]
pub fn is_exact_period(seconds: f64) -> bool {
    let steps = seconds / PERIOD_STEP;
    (steps - steps.round()).abs() < 1e-6
}

/// Period in whole steps, rounded down as the controller does; `None` for an invalid period.
#[must_use]
pub fn period_steps(seconds: f64) -> Option<u32> {
    let steps = (seconds / PERIOD_STEP + 1e-6).floor();
    (seconds > 0.0 && steps <= f64::from(u32::MAX)).then_some(steps as u32)
}

/// Fault in a task name.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum NameFault {
    /// The name is empty.
    Empty,
    /// The name is longer than this limit.
    Long(usize),
    /// The name has a character other than `a` to `z`, `A` to `Z`, `0` to `9` and `_`.
    Character(char),
}

/// Fault in a task name in this version; `None` for a valid name.
///
/// A name has 1 to 15 characters up to s7 (5.10). Applications of s8 use longer names.
#[must_use]
pub fn name_fault(name: &str, version: Version) -> Option<NameFault> {
    let odd = name.chars().find(|character| !character.is_ascii_alphanumeric() && *character != '_');
    let limit = version.identifier_limit().filter(|limit| name.chars().count() > *limit);
    let empty = name.is_empty().then_some(NameFault::Empty);
    empty.or(odd.map(NameFault::Character)).or(limit.map(NameFault::Long))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_have_one_to_fifteen_characters() {
        let [s7, s8] = ["s7.11", "s8.10"].map(|text| Version::parse(text).unwrap());
        for good in ["a", "abcdefghijklmno", "1_B"] {
            assert_eq!(name_fault(good, s7), None);
        }
        assert_eq!(name_fault("", s8), Some(NameFault::Empty));
        assert_eq!(name_fault("abcdefghijklmnop", s7), Some(NameFault::Long(15)));
        assert_eq!(name_fault("abcdefghijklmnop", s8), None);
        assert_eq!(name_fault("a b", s8), Some(NameFault::Character(' ')));
    }

    #[test]
    fn periods_count_four_milliseconds() {
        assert!(is_exact_period(0.004) && is_exact_period(0.02) && is_exact_period(16.0));
        assert!(!is_exact_period(0.01) && !is_exact_period(0.005) && !is_exact_period(0.001));
    }

    #[test]
    fn periods_are_rounded_down() {
        assert_eq!(period_steps(0.02), Some(5));
        assert_eq!(period_steps(0.01), Some(2));
        assert_eq!(period_steps(0.0), None);
    }

    #[test]
    fn both_numbers_have_a_range() {
        assert!(priority().is_some_and(|range| range.takes(100.0) && !range.takes(101.0)));
        assert!(period().is_some_and(|range| range.takes(0.001) && !range.takes(0.0)));
    }
}
