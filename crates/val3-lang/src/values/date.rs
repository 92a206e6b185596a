//! Date and time as text: `getDate` (4.3).

use std::fmt::{self, Write};

use super::Text;

/// A day and a time of day of the Gregorian calendar, as a clock shows them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct DateTime {
    /// The year, such as 2007.
    pub year: u16,
    /// 1 to 12.
    pub month: u8,
    /// 1 to 31.
    pub day: u8,
    /// 0 to 23.
    pub hour: u8,
    /// 0 to 59.
    pub minute: u8,
    /// 0 to 59.
    pub second: u8,
}

impl DateTime {
    /// `getDate`: the format with its marks replaced, cut at 128 bytes.
    ///
    /// `%y` and `%Y` year, `%m` month, `%d` day, `%H` hour of 24, `%I` hour of 12 from 01 to 12, `%p` AM or PM, `%M`
    /// minute, `%S` second; all but `%Y` and `%p` of two digits. Everything else is copied, including other letters
    /// after `%`.
    #[must_use]
    pub fn format(&self, format: &str) -> Text {
        Text::from(format_args!("{}", FormattedDate { date: self, format }))
    }

    /// Writes what takes the place of `%` and this key; `None` for a key that has no meaning.
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

/// A format whose marks a date fills.
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
