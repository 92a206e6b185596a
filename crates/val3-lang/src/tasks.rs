//! What the controller asks of tasks (5.5, 5.10).

use crate::arguments::{Range, range};

/// The unit of periods in seconds; the controller rounds a period down to a multiple of it.
pub const PERIOD_STEP: f64 = 0.004;

/// The number of different periods that synchronous tasks can have at a time; one more is run-time error 32.
pub const MAX_PERIODS: usize = 2;

/// The number of characters a task's name can have.
pub const NAME_LIMIT: usize = 15;

/// The run-time error of a bad name.
pub const NAME_ERROR: u16 = 29;

/// The lines that a task runs in its turn.
#[must_use]
pub fn priority() -> Option<&'static Range> {
    range("taskCreate", "nPriority")
}

/// The time between two turns of a synchronous task in seconds.
#[must_use]
pub fn period() -> Option<&'static Range> {
    range("taskCreateSync", "nPeriod")
}

/// The period is a multiple of the controller's unit, but for what a decimal fraction cannot say exactly.
#[must_use]
pub fn is_exact_period(seconds: f64) -> bool {
    let steps = seconds / PERIOD_STEP;
    (steps - steps.round()).abs() < 1e-6
}

/// A task can have this name: 1 to 15 of the characters `a` to `z`, `A` to `Z`, `0` to `9` and `_`.
#[must_use]
pub fn is_name(text: &str) -> bool {
    let allowed = |byte: u8| byte.is_ascii_alphanumeric() || byte == b'_';
    (1..=NAME_LIMIT).contains(&text.len()) && text.bytes().all(allowed)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_have_one_to_fifteen_characters() {
        assert!(is_name("a") && is_name("abcdefghijklmno") && is_name("1_B"));
        assert!(!is_name("") && !is_name("abcdefghijklmnop") && !is_name("a b") && !is_name("ä"));
    }

    #[test]
    fn periods_count_four_milliseconds() {
        assert!(is_exact_period(0.004) && is_exact_period(0.02) && is_exact_period(16.0));
        assert!(!is_exact_period(0.01) && !is_exact_period(0.005) && !is_exact_period(0.001));
    }

    #[test]
    fn both_numbers_have_a_range() {
        assert!(priority().is_some_and(|range| range.takes(100.0) && !range.takes(101.0)));
        assert!(period().is_some_and(|range| range.takes(0.001) && !range.takes(0.0)));
    }
}
