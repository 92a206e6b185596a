//! Versions of VAL 3 and their differences.

use std::fmt;

/// A version of VAL 3: s5 to s7 run on CS8 controllers, s8 on CS9.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Version {
    /// Number after the `s`.
    pub major: u8,
    /// Minor version; 0 if missing.
    pub minor: u16,
    /// Patch version; 0 if missing.
    pub patch: u16,
    /// Whether a version below s8 names the controller CS9: `s7.0.1Cs9` in templates of this controller.
    pub on_cs9: bool,
}

impl Default for Version {
    fn default() -> Self {
        Self::DEFAULT
    }
}

impl Version {
    /// Version for a project that does not state one: the version of the manual.
    pub const DEFAULT: Self = Self::new(7, 11, 0);

    /// Creates the version `s{major}.{minor}.{patch}`.
    #[must_use]
    pub const fn new(major: u8, minor: u16, patch: u16) -> Self {
        Self { major, minor, patch, on_cs9: false }
    }

    /// Parses a version in project files: `s7.11.3`, `s8.10.2Cs9_BS1991`, and the composite
    /// `~VAL3:s5.2.4~Options:s5.2.4~` of s5. In the text after the third number, only `Cs9` below s8 has a meaning.
    ///
    /// ```
    /// use val3_lang::versions::Version;
    /// assert_eq!(Version::parse("s8.10.2Cs9_BS1991"), Some(Version::new(8, 10, 2)));
    /// assert_eq!(Version::parse("8"), None);
    /// ```
    #[must_use]
    pub fn parse(text: &str) -> Option<Self> {
        let text = language_part(text.trim()).strip_prefix(['s', 'S'])?;
        let suffix = text.trim_start_matches(|c: char| c.is_ascii_digit() || c == '.');
        let is_cs9 = suffix.get(..CS9.len()).is_some_and(|start| start.eq_ignore_ascii_case(CS9));
        let mut numbers = text.splitn(3, '.').map(leading_digits);
        let major = numbers.next()?.parse().ok()?;
        let mut rest = || numbers.next().and_then(|digits| digits.parse().ok()).unwrap_or(0);
        Some(Self { major, minor: rest(), patch: rest(), on_cs9: is_cs9 && major < FIRST_OF_CS9 })
    }

    /// First number of the controller's language version: 8 for every CS9.
    #[must_use]
    pub fn language(self) -> u8 {
        if self.on_cs9 { FIRST_OF_CS9 } else { self.major }
    }

    /// Maximum number of characters in an identifier; `None` if there is no known limit.
    ///
    /// 15 up to s7 (2.5.1). Applications of s8 use 36 and more.
    #[must_use]
    pub fn identifier_limit(self) -> Option<usize> {
        (self.language() < 8).then_some(15)
    }

    /// Maximum number of elements in a variable after `insert`, `append` and `resize` (2.5.4); `None` if it is only
    /// limited by memory (s8).
    #[must_use]
    pub fn container_limit(self) -> Option<u32> {
        (self.language() < 8).then_some(9999)
    }

    /// Whether `power` computes whole exponents of a negative base (s8; 3.2.3).
    #[must_use]
    pub fn raises_negative_numbers(self) -> bool {
        self.language() >= 8
    }

    /// Whether `toBinary` encodes all available numbers if more are requested (s8; 3.3.3).
    #[must_use]
    pub fn encodes_what_exists(self) -> bool {
        self.language() >= 8
    }

    /// Whether a synchronous task with a shorter period than 4 ms has a period of 4 ms, instead of raising error 70 (s8;
    /// 5.10).
    #[must_use]
    pub fn lengthens_short_periods(self) -> bool {
        self.language() >= 8
    }

    /// Whether a project's `<Program file>` may name a sub-folder (s8.20 on).
    #[must_use]
    pub fn allows_sub_folders(self) -> bool {
        self >= Self::new(8, 20, 0)
    }

    /// Whether user types exist (s7 on).
    #[must_use]
    pub fn has_user_types(self) -> bool {
        self.major >= 7
    }

    /// Whether collections and multidimensional arrays exist (from s7 on).
    #[must_use]
    pub fn has_collections(self) -> bool {
        self.major >= 7
    }

    /// Whether `dio = dio` copies an input's state to an output (before s7; 3.5.2).
    #[must_use]
    pub fn assigns_dio_to_dio(self) -> bool {
        self.major < 7
    }
}

/// Name of the s8 controller in versions.
const CS9: &str = "Cs9";

/// First number of the versions on [`CS9`].
const FIRST_OF_CS9: u8 = 8;

/// Versions that known applications declare, newest first.
pub const KNOWN: [&str; 12] =
    ["s8.20", "s8.13", "s8.10", "s8.3", "s7.11.3", "s7.11", "s7.10", "s7.8", "s7.7", "s7.3", "s6.8", "s5.4"];

impl fmt::Display for Version {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "s{}.{}", self.major, self.minor)?;
        if self.patch > 0 {
            write!(f, ".{}", self.patch)?;
        }
        if self.on_cs9 {
            f.write_str(CS9)?;
        }
        Ok(())
    }
}

/// Language part of a composite version.
fn language_part(text: &str) -> &str {
    text.split('~').find_map(|part| part.strip_prefix("VAL3:")).unwrap_or(text)
}

fn leading_digits(text: &str) -> &str {
    let end = text.find(|c: char| !c.is_ascii_digit()).unwrap_or(text.len());
    text.get(..end).unwrap_or(text)
}

#[cfg(test)]
mod tests {
    use super::Version;

    #[test]
    fn reads_every_form_of_the_files() {
        let cases = [
            ("s7.11.3", (7, 11, 3)),
            ("s7.0", (7, 0, 0)),
            ("s6.8", (6, 8, 0)),
            ("s8.3Cs9_BS845", (8, 3, 0)),
            ("s8.10.2cs9_BS1991", (8, 10, 2)),
            ("s8.20.2Cs9_BS4270", (8, 20, 2)),
            ("~VAL3:s5.2.4~Options:s5.2.4~Arm:x", (5, 2, 4)),
            ("~VAL3:s5.4", (5, 4, 0)),
        ];
        for (text, (major, minor, patch)) in cases {
            assert_eq!(Version::parse(text), Some(Version::new(major, minor, patch)), "{text}");
        }
        for text in ["", "7.1", "sx", "~Options:s5", "s999"] {
            assert_eq!(Version::parse(text), None, "{text}");
        }
    }

    #[test]
    fn a_version_below_s8_may_name_the_controller_of_s8() {
        let template = Version::parse("s7.0.1Cs9").unwrap();
        assert_eq!((template.major, template.language(), template.identifier_limit()), (7, 8, None));
        assert_eq!(template.to_string(), "s7.0.1Cs9");
        assert_eq!(Version::parse("s7.0.1cs9_BS1"), Some(template));
        assert_eq!(Version::parse("s7.0.1").map(Version::language), Some(7));
    }

    #[test]
    fn knows_the_features_that_each_version_lacks() {
        let (s6, s7, s8) = (Version::new(6, 8, 0), Version::DEFAULT, Version::new(8, 20, 0));
        assert_eq!((s7.identifier_limit(), s8.identifier_limit()), (Some(15), None));
        assert!(s8.allows_sub_folders() && !Version::new(8, 13, 1).allows_sub_folders());
        assert!(s6.assigns_dio_to_dio() && !s7.assigns_dio_to_dio());
        assert!(!s6.has_user_types() && s7.has_collections());
        assert_eq!(Version::new(8, 3, 0).to_string(), "s8.3");
    }
}
