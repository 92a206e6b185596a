//! Date and time on a controller's clock, whose time zone is unknown.

use std::fmt;

use chrono::{DateTime as UnixTime, Datelike as _, NaiveDate, NaiveDateTime, TimeDelta};

/// Abbreviations of months in logs of a CS8.
const MONTHS: [&str; 12] = ["JAN", "FEB", "MAR", "APR", "MAY", "JUN", "JUL", "AUG", "SEP", "OCT", "NOV", "DEC"];

/// Last year that four digits can show.
const LAST_YEAR: u16 = 9999;

/// Date and time, to the second.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct DateTime(NaiveDateTime);

impl DateTime {
    /// Reads `2021-01-05T08:00:00`. A blank may replace the `T`; the seconds, and the entire time, may be missing.
    #[must_use]
    pub fn parse(text: &str) -> Option<Self> {
        let (date, time) = text.split_once(['T', ' ']).unwrap_or((text, "00:00"));
        let [year, month, day] = parts(date, '-')?;
        Self::new(year.parse().ok()?, month.parse().ok()?, day, time)
    }

    /// Reads the time of a CS8 message: `01/05/21 08:00:00` (month first) or `JAN 05 2021 08:00:00`.
    pub(crate) fn parse_cs8(text: &str) -> Option<Self> {
        if let Some((date, time)) = text.split_once(' ')
            && let Some([month, day, year]) = parts(date, '/')
        {
            return Self::new(2000 + year.parse::<u8>().ok().map(u16::from)?, month.parse().ok()?, day, time);
        }
        let words: Vec<&str> = text.split_ascii_whitespace().collect();
        let [month, day, year, time] = words.as_slice() else { return None };
        let month = MONTHS.iter().zip(1..).find(|(name, _)| name.eq_ignore_ascii_case(month))?.1;
        Self::new(year.parse().ok()?, month, day, time)
    }

    /// Creates a time from seconds since 1970-01-01 00:00:00; `None` outside of the years 0 to 9999.
    #[must_use]
    pub fn from_unix(seconds: i64) -> Option<Self> {
        let time = UnixTime::from_timestamp(seconds, 0)?.naive_utc();
        (0..=LAST_YEAR.into()).contains(&time.year()).then_some(Self(time))
    }

    /// Returns the time this number of seconds earlier, limited to the first date that exists.
    #[must_use]
    pub fn minus_seconds(self, seconds: u32) -> Self {
        Self(self.0.checked_sub_signed(TimeDelta::seconds(seconds.into())).unwrap_or(NaiveDateTime::MIN))
    }

    fn new(year: u16, month: u8, day: &str, time: &str) -> Option<Self> {
        let date =
            NaiveDate::from_ymd_opt(year.into(), month.into(), day.parse().ok()?).filter(|_| year <= LAST_YEAR)?;
        let mut parts = time.split(':').map(|part| part.parse().ok());
        let (hour, minute, second) = (parts.next()??, parts.next()??, parts.next().unwrap_or(Some(0))?);
        let time = date.and_hms_opt(hour, minute, second)?;
        parts.next().is_none().then_some(Self(time))
    }
}

/// Splits a date in its three numbers.
fn parts(text: &str, separator: char) -> Option<[&str; 3]> {
    let parts: Vec<&str> = text.split(separator).collect();
    <[&str; 3]>::try_from(parts).ok()
}

impl fmt::Display for DateTime {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:04}-{}", self.0.year(), self.0.format("%m-%d %H:%M:%S"))
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn shown(time: Option<DateTime>) -> String {
        time.map_or_else(|| "none".to_owned(), |time| time.to_string())
    }

    #[test]
    fn every_form_is_read() {
        assert_eq!(shown(DateTime::parse("2021-01-05T08:00:09")), "2021-01-05 08:00:09");
        assert_eq!(shown(DateTime::parse("2021-01-05 23:59")), "2021-01-05 23:59:00");
        assert_eq!(shown(DateTime::parse("2020-02-29")), "2020-02-29 00:00:00");
        assert_eq!(shown(DateTime::parse_cs8("01/19/15 15:53:04")), "2015-01-19 15:53:04");
        assert_eq!(shown(DateTime::parse_cs8("FEB 21 2021 02:58:57")), "2021-02-21 02:58:57");
    }

    #[test]
    fn other_texts_are_no_times() {
        for text in ["", "2021", "2021-13-01", "2021-02-29", "2021-01-05T24:00:00", "2021-01-05T08:00:00:00", "x-y-z"] {
            assert_eq!(shown(DateTime::parse(text)), "none", "{text}");
        }
        for text in
            ["", "19/01/15 15:53:04", "01/19/15", "FEV 21 2021 02:58:57", "99999/1/1 00:00:00", "1/1/99999 0:0:0"]
        {
            assert_eq!(shown(DateTime::parse_cs8(text)), "none", "{text}");
        }
    }

    #[test]
    fn the_epoch_is_known() {
        assert_eq!(shown(DateTime::from_unix(0)), "1970-01-01 00:00:00");
        assert_eq!(shown(DateTime::from_unix(1_582_934_400)), "2020-02-29 00:00:00");
        assert_eq!(shown(DateTime::from_unix(i64::MAX / 2)), "none");
    }

    proptest! {
        #[test]
        fn a_shown_time_is_read_again(seconds in -60_000_000_000_i64..250_000_000_000) {
            let time = DateTime::from_unix(seconds).unwrap();
            prop_assert_eq!(DateTime::parse(&time.to_string()), Some(time));
            prop_assert_eq!(DateTime::from_unix(seconds - 90), Some(time.minus_seconds(90)));
        }

        #[test]
        fn any_text_is_read_without_a_panic(text: String) {
            let _ = (DateTime::parse(&text), DateTime::parse_cs8(&text));
        }
    }
}
