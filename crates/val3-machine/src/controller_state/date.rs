//! Date of the controller (`getDate`, 4.3).

use time::{Date, Duration, Month, PrimitiveDateTime, Time};
use val3_lang::values::date::DateTime;

/// Calendar of the controller: virtual time counted from a date.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Calendar {
    start: PrimitiveDateTime,
}

impl Default for Calendar {
    /// Start on the first of January 2024 at midnight, so that all runs are alike.
    fn default() -> Self {
        Self { start: new_year(2024) }
    }
}

/// Start of a year.
fn new_year(year: i32) -> PrimitiveDateTime {
    let day = Date::from_calendar_date(year, Month::January, 1).unwrap_or(Date::MIN);
    PrimitiveDateTime::new(day, Time::MIDNIGHT)
}

impl Calendar {
    /// Calendar with this start date; `None` if the date does not exist.
    #[must_use]
    pub fn starting_at(date: DateTime) -> Option<Self> {
        let DateTime { year, month, day, hour, minute, second } = date;
        let day = Date::from_calendar_date(year.into(), month.try_into().ok()?, day).ok()?;
        let time = Time::from_hms(hour, minute, second).ok()?;
        Some(Self { start: PrimitiveDateTime::new(day, time) })
    }

    /// Calendar that starts this number of seconds after 1970 (UTC).
    #[must_use]
    pub fn starting_at_unix(seconds: u64) -> Self {
        let seconds = Duration::seconds(i64::try_from(seconds).unwrap_or(i64::MAX));
        Self { start: new_year(1970).saturating_add(seconds) }
    }

    /// Returns the date `elapsed` nanoseconds after the start, limited to the last date that exists.
    #[must_use]
    pub fn after(&self, elapsed: u64) -> DateTime {
        let elapsed = Duration::nanoseconds(i64::try_from(elapsed).unwrap_or(i64::MAX));
        let date = self.start.saturating_add(elapsed);
        DateTime {
            year: u16::try_from(date.year()).unwrap_or_default(),
            month: date.month().into(),
            day: date.day(),
            hour: date.hour(),
            minute: date.minute(),
            second: date.second(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const NEW_YEAR: DateTime = DateTime { year: 2007, month: 1, day: 1, hour: 13, minute: 45, second: 23 };

    #[test]
    fn the_date_follows_the_clock() {
        let hour = 3_600_000_000_000;
        let calendar = Calendar::starting_at(NEW_YEAR).unwrap();
        assert_eq!(calendar.after(999_999_999), NEW_YEAR);
        assert_eq!(calendar.after(11 * hour), DateTime { day: 2, hour: 0, ..NEW_YEAR });
        assert_eq!(calendar.after(u64::MAX).year, 2299);
    }

    #[test]
    fn the_date_of_a_computer_is_converted() {
        assert_eq!(Calendar::starting_at_unix(1_167_659_123).after(0), NEW_YEAR);
    }

    #[test]
    fn only_existing_dates_are_accepted() {
        assert_eq!(Calendar::starting_at(DateTime { month: 2, day: 30, ..NEW_YEAR }), None);
        assert_eq!(Calendar::starting_at(DateTime { hour: 24, ..NEW_YEAR }), None);
        assert_eq!(Calendar::default().after(0).format("%Y-%m-%d %H:%M:%S").as_str(), "2024-01-01 00:00:00");
    }
}
