//! Date and time as text (`getDate`, 4.3).

use time::{Duration, PrimitiveDateTime};

/// The date `elapsed` nanoseconds after `start`; the last one that exists, where that lies beyond it.
#[must_use]
pub fn date_after(start: PrimitiveDateTime, elapsed: u64) -> PrimitiveDateTime {
    let elapsed = Duration::nanoseconds(i64::try_from(elapsed).unwrap_or(i64::MAX));
    start.saturating_add(elapsed)
}

/// `format` with its keys replaced by the parts of `date`; what is no key stays.
///
/// Twelve o'clock is `12` of a clock of twelve hours; `%p` is `AM` or `PM`.
#[must_use]
pub fn date_text(format: &str, date: PrimitiveDateTime) -> String {
    let mut text = String::new();
    let mut rest = format;
    while let Some((before, behind)) = rest.split_once('%') {
        text.push_str(before);
        let part = behind.chars().next().and_then(|key| part(key, date));
        if part.is_none() {
            text.push('%');
        }
        rest = behind.get(usize::from(part.is_some())..).unwrap_or_default();
        text.push_str(&part.unwrap_or_default());
    }
    text + rest
}

fn part(key: char, date: PrimitiveDateTime) -> Option<String> {
    let two = |number: u8| Some(format!("{number:02}"));
    match key {
        'y' => Some(format!("{:02}", date.year().rem_euclid(100))),
        'Y' => Some(format!("{:04}", date.year())),
        'm' => two(date.month().into()),
        'd' => two(date.day()),
        'H' => two(date.hour()),
        'I' => two((date.hour() + 11) % 12 + 1),
        'p' => Some(if date.hour() < 12 { "AM" } else { "PM" }.to_owned()),
        'M' => two(date.minute()),
        'S' => two(date.second()),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use time::{Date, Month, Time};
    use val3_lang::arguments::DATE_KEYS;

    fn date(hour: u8, minute: u8) -> PrimitiveDateTime {
        let day = Date::from_calendar_date(2007, Month::January, 1).unwrap();
        PrimitiveDateTime::new(day, Time::from_hms(hour, minute, 23).unwrap())
    }

    #[test]
    fn the_example_of_the_manual() {
        assert_eq!(date_text("%m", date(13, 45)), "01");
        assert_eq!(date_text("January %d, %Y %H:%M:%S", date(13, 45)), "January 01, 2007 13:45:23");
    }

    #[test]
    fn every_key_has_a_part() {
        for key in DATE_KEYS {
            assert!(!date_text(key, date(13, 45)).contains('%'), "{key}");
        }
        assert_eq!(date_text("%y", date(0, 0)), "07");
    }

    #[test]
    fn the_clock_of_twelve_hours() {
        let at = |hour| date_text("%I %p", date(hour, 0));
        assert_eq!(
            [at(0), at(1), at(11), at(12), at(13), at(23)],
            ["12 AM", "01 AM", "11 AM", "12 PM", "01 PM", "11 PM"]
        );
    }

    #[test]
    fn what_is_no_key_stays() {
        assert_eq!(date_text("100% %D %%d %é", date(0, 0)), "100% %D %01 %é");
        assert_eq!(date_text("%", date(0, 0)), "%");
        assert_eq!(date_text("", date(0, 0)), "");
    }

    #[test]
    fn time_goes_on() {
        let hour = 3_600_000_000_000;
        assert_eq!(date_text("%d %H:%M", date_after(date(13, 45), 11 * hour)), "02 00:45");
        assert_eq!(date_text("%Y", date_after(date(0, 0), u64::MAX)), "2299");
    }
}
