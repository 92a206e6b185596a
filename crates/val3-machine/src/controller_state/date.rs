//! Date of the controller (`getDate`, 4.3).

use chrono::{DateTime as UnixTime, Datelike as _, NaiveDate, NaiveDateTime, NaiveTime, TimeDelta, Timelike as _};
use val3_lang::values::date::DateTime;

/// Calendar of the controller: virtual time counted from a date.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Calendar {
    start: NaiveDateTime,
}

impl Default for Calendar {
    /// Start on the first of January 2024 at midnight, so that all runs are alike.
    fn default() -> Self {
        Self::starting_at_unix(NEW_YEAR_2024)
    }
}

/// Seconds from 1970 to 2024 (UTC).
const NEW_YEAR_2024: u64 = 1_704_067_200;

/// Last date whose year has four digits.
const LAST_DATE: NaiveDateTime = match NaiveDate::from_ymd_opt(9999, 12, 31) {
    Some(day) => day.and_time(NaiveTime::MIN),
    None => NaiveDateTime::MAX,
};

impl Calendar {
    /// Calendar with this start date; `None` if the date does not exist.
    #[must_use]
    pub fn starting_at(date: DateTime) -> Option<Self> {
        let DateTime { year, month, day, hour, minute, second } = date;
        let day = NaiveDate::from_ymd_opt(year.into(), month.into(), day.into())?;
        let start = day.and_hms_opt(hour.into(), minute.into(), second.into())?;
        (start <= LAST_DATE).then_some(Self { start })
    }

    /// Calendar that starts this number of seconds after 1970 (UTC), limited to the last date that exists.
    #[must_use]
    pub fn starting_at_unix(seconds: u64) -> Self {
        let date = i64::try_from(seconds).ok().and_then(|seconds| UnixTime::from_timestamp(seconds, 0));
        Self { start: date.map_or(LAST_DATE, |date| date.naive_utc().min(LAST_DATE)) }
    }

    /// Returns the date `elapsed` nanoseconds after the start, limited to the last date that exists.
    #[must_use]
    pub fn after(&self, elapsed: u64) -> DateTime {
        let elapsed = TimeDelta::nanoseconds(i64::try_from(elapsed).unwrap_or(i64::MAX));
        let date = self.start.checked_add_signed(elapsed).unwrap_or(LAST_DATE).min(LAST_DATE);
        DateTime {
            year: u16::try_from(date.year()).unwrap_or_default(),
            month: two_digits(date.month()),
            day: two_digits(date.day()),
            hour: two_digits(date.hour()),
            minute: two_digits(date.minute()),
            second: two_digits(date.second()),
        }
    }
}

/// A number of at most two digits.
fn two_digits(number: u32) -> u8 {
    u8::try_from(number).unwrap_or_default()
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
