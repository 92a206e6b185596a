//! Date and time as a string: `getDate` (4.3).

use std::fmt::{self, Write};

use super::Text;

/// A date and a time of the Gregorian calendar.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct DateTime {
    /// Year, for example 2007.
    pub year: u16,
    /// Month, 1 to 12.
    pub month: u8,
    /// Day, 1 to 31.
    pub day: u8,
    /// Hour, 0 to 23.
    pub hour: u8,
    /// Minute, 0 to 59.
    pub minute: u8,
    /// Second, 0 to 59.
    pub second: u8,
}

impl DateTime {
    /// `getDate`: replaces the keys in a format; the result is cut at 128 bytes.
    ///
    /// `%y` and `%Y` year, `%m` month, `%d` day, `%H` hour 00 to 23, `%I` hour 01 to 12, `%p` AM or PM, `%M` minute,
    /// `%S` second; all except `%Y` and `%p` have two digits. Other text is copied, including `%` with other letters.
    #[must_use]
    pub fn format(&self, format: &str) -> Text {
        Text::from(format_args!("{}", FormattedDate { date: self, format }))
    }

    /// Writes the replacement of `%` and this key; `None` for an unknown key.
    fn write(&self, key: char, f: &mut fmt::Formatter<'_>) -> Option<fmt::Result> {
        Some(match key {
            'y' => write!(f, "{:02}", self.year % 100),
            'Y' => write!(f, "{:04}", self.year),
            'm' => write!(f, "{:02}", self.month),
            'd' => write!(f, "{:02}", self.day),
            'H' => write!(f, "{:02}", self.hour),
            'I' => write!(f, "{:02}", (self.hour % 12 + 11) % 12 + 1),
            'p' => f.write_str(if self.hour < 12 { "AM" } else { "PM" }),
            'M' => write!(f, "{:02}", self.minute),
            'S' => write!(f, "{:02}", self.second),
            _ => return None,
        })
    }
}

/// A format with the date that replaces its keys.
struct FormattedDate<'a> {
    date: &'a DateTime,
    format: &'a str,
}

impl fmt::Display for FormattedDate<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut rest = self.format;
        while let Some((before, behind)) = rest.split_once('%') {
            f.write_str(before)?;
            let mut following = behind.chars();
            rest = match following.next().and_then(|key| self.date.write(key, f)) {
                Some(written) => written.map(|()| following.as_str())?,
                None => f.write_char('%').map(|()| behind)?,
            };
        }
        f.write_str(rest)
    }
}

#[cfg(test)]
mod tests {
    use super::DateTime;

    const NEW_YEAR: DateTime = DateTime { year: 2007, month: 1, day: 1, hour: 13, minute: 45, second: 23 };

    #[track_caller]
    fn check(format: &str, expected: &str) {
        assert_eq!(NEW_YEAR.format(format).as_str(), expected);
    }

    #[test]
    fn formats_as_the_manual_does() {
        check("%m", "01");
        check("January %d, %Y %H:%M:%S", "January 01, 2007 13:45:23");
    }

    #[test]
    fn replaces_every_mark() {
        check("%y %Y %m %d", "07 2007 01 01");
        check("%H %I %p %M %S", "13 01 PM 45 23");
        check("%Y%Y", "20072007");
    }

    #[test]
    fn everything_else_stays() {
        check("", "");
        check("noon", "noon");
        check("100% %x %é %", "100% %x %é %");
        check("%%", "%%");
        check("%%Y", "%2007");
        check("年%Y", "年2007");
    }

    #[test]
    fn twelve_hours_start_with_twelve() {
        let shown = |hour| DateTime { hour, ..NEW_YEAR }.format("%H %I %p").to_string();
        assert_eq!([0, 1, 11].map(shown), ["00 12 AM", "01 01 AM", "11 11 AM"]);
        assert_eq!([12, 13, 23].map(shown), ["12 12 PM", "13 01 PM", "23 11 PM"]);
    }

    #[test]
    fn years_have_two_or_four_digits() {
        let shown = |year| DateTime { year, ..NEW_YEAR }.format("%y %Y").to_string();
        assert_eq!([1999, 2000, 2100].map(shown), ["99 1999", "00 2000", "00 2100"]);
    }

    #[test]
    fn fills_a_string_at_most() {
        let full = "x".repeat(126);
        check(&format!("{full}%S"), &format!("{full}23"));
        check(&format!("{full}x%Sx"), &format!("{full}x2"));
        check(&format!("{full}x年%S"), &format!("{full}x"));
    }
}
