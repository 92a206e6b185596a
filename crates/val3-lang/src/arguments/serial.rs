//! Parameters of serial lines and sockets (3.7.3).

use crate::types::BaseType;

/// A parameter of a serial line or socket that a program can change.
#[derive(Debug, PartialEq)]
pub struct SerialParameter {
    /// Name.
    pub name: &'static str,
    /// Valid values.
    pub value: SerialValue,
}

/// Valid values of a parameter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SerialValue {
    /// Any truth value.
    Truth,
    /// Any string.
    Text,
    /// One of these strings.
    OneOf(&'static [&'static str]),
    /// Any number.
    Number,
    /// A whole number in this range.
    Between(u16, u16),
}

/// Error in a value, which determines the instruction's return code in place of 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SerialFault {
    /// -1: the parameter does not exist.
    Unknown,
    /// -2: the value has the wrong type.
    Type,
    /// -3: the value is invalid for the parameter.
    Value,
}

/// All parameters of lines and sockets.
pub static SERIAL_PARAMETERS: [SerialParameter; 12] = [
    row("port", SerialValue::Number),
    row("target", SerialValue::Text),
    row("clients", SerialValue::Number),
    row("endOfString", SerialValue::Between(0, 255)),
    row("timeout", SerialValue::Number),
    row("baudRate", SerialValue::Number),
    row("parity", SerialValue::OneOf(&["none", "even", "odd"])),
    row("bits", SerialValue::Between(5, 8)),
    row("stopBits", SerialValue::Between(1, 2)),
    row("mode", SerialValue::OneOf(&["rs232", "rs422"])),
    row("flowControl", SerialValue::OneOf(&["none", "hardware"])),
    row("nagle", SerialValue::Truth),
];

const fn row(name: &'static str, value: SerialValue) -> SerialParameter {
    SerialParameter { name, value }
}

impl SerialParameter {
    /// Finds a parameter by name, in upper or lower case.
    #[must_use]
    pub fn find(name: &str) -> Option<&'static Self> {
        SERIAL_PARAMETERS.iter().find(|row| row.name.eq_ignore_ascii_case(name))
    }
}

impl SerialValue {
    /// Type of the values.
    #[must_use]
    pub fn ty(self) -> BaseType {
        match self {
            Self::Truth => BaseType::Bool,
            Self::Text | Self::OneOf(_) => BaseType::String,
            Self::Number | Self::Between(..) => BaseType::Num,
        }
    }

    /// Whether the number is valid for the parameter.
    #[must_use]
    pub fn takes_number(self, number: f64) -> bool {
        match self {
            Self::Between(low, high) => (f64::from(low)..=f64::from(high)).contains(&number),
            _ => self.ty() == BaseType::Num,
        }
    }

    /// Whether the string is valid for the parameter, in upper or lower case.
    #[must_use]
    pub fn takes_text(self, text: &str) -> bool {
        match self {
            Self::OneOf(texts) => texts.iter().any(|known| known.eq_ignore_ascii_case(text)),
            _ => self.ty() == BaseType::String,
        }
    }
}

impl SerialFault {
    /// Return code of the instruction.
    #[must_use]
    pub fn result(self) -> i8 {
        match self {
            Self::Unknown => -1,
            Self::Type => -2,
            Self::Value => -3,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_found_in_any_letter_case() {
        assert_eq!(SerialParameter::find("baudrate").map(|row| row.name), Some("baudRate"));
        assert_eq!(SerialParameter::find("speed"), None);
    }

    #[test]
    fn values_suit_their_parameter() {
        let value = |name| SerialParameter::find(name).unwrap().value;
        assert!(value("bits").takes_number(8.0) && !value("bits").takes_number(9.0));
        assert!(value("mode").takes_text("RS422") && !value("mode").takes_text("rs485"));
        assert!(value("target").takes_text("10.0.0.1") && !value("target").takes_number(1.0));
        assert_eq!(value("nagle").ty(), BaseType::Bool);
    }
}
