//! Severity of messages.

/// Severity of a message in `logMsg` and `popUpMsg` (s8); the default is information.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum MessageSeverity {
    /// 1.
    #[default]
    Information,
    /// 2.
    Warning,
    /// 3.
    Error,
}

impl MessageSeverity {
    /// Returns the severity with this number; any number except 2 and 3 is an information.
    #[must_use]
    pub fn from_number(number: f64) -> Self {
        if number == 2.0 {
            Self::Warning
        } else if number == 3.0 {
            Self::Error
        } else {
            Self::Information
        }
    }

    /// `info`, `warning` or `error`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Information => "info",
            Self::Warning => "warning",
            Self::Error => "error",
        }
    }

    /// 1 to 3.
    #[must_use]
    pub fn number(self) -> u8 {
        self as u8 + 1
    }
}

#[cfg(test)]
mod tests {
    use super::MessageSeverity;

    #[test]
    fn numbers_and_severities_are_converted_both_ways() {
        for number in [1, 2, 3] {
            assert_eq!(MessageSeverity::from_number(f64::from(number)).number(), number);
        }
        assert_eq!(MessageSeverity::from_number(7.0), MessageSeverity::Information);
    }
}
