//! Configuration of inputs and outputs.

use val3_lang::io_paths::is_input;

/// Whether programs may write the signal.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Direction {
    /// Read only.
    Input,
    /// Read and written.
    Output,
}

/// Value range of analog signals.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SignalRange {
    /// Any number.
    Float,
    /// Whole numbers from `lowest` to `highest`.
    Whole {
        /// The lowest value.
        lowest: f64,
        /// The highest value.
        highest: f64,
    },
}

impl SignalRange {
    /// Rounds and limits a written value to the value of the signal.
    #[must_use]
    pub fn fit(self, value: f64) -> f64 {
        match self {
            Self::Float => value,
            Self::Whole { lowest, highest } => (value + 0.5).floor().max(lowest).min(highest),
        }
    }
}

/// Type of variable that can be linked to a signal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SignalKind {
    /// `dio`: 0 or 1.
    Digital,
    /// `aio`.
    Analog(SignalRange),
}

impl SignalKind {
    /// Whether a variable of the kind `other` can be linked to a signal of this kind; the format does not matter.
    #[must_use]
    pub fn suits(self, other: Self) -> bool {
        matches!((self, other), (Self::Digital, Self::Digital) | (Self::Analog(_), Self::Analog(_)))
    }

    /// Converts a written value to the value of the signal.
    #[must_use]
    pub fn fit(self, value: f64) -> f64 {
        match self {
            Self::Digital => f64::from(u8::from(value != 0.0)),
            Self::Analog(format) => format.fit(value),
        }
    }
}

/// An input or output of the controller.
#[derive(Debug, Clone, PartialEq)]
pub struct Signal {
    /// Physical path as in the links of data files: `BasicIO-1\%I0`, `FastIO\fOut0`, `valve1`.
    pub path: String,
    /// Free text, which `ioStatus` returns.
    pub description: String,
    /// Type and value range.
    pub kind: SignalKind,
    /// Whether programs may write the signal.
    pub direction: Direction,
    /// Whether the output is reserved for the system: writing it is run-time error 124.
    pub protected: bool,
}

impl Signal {
    /// Creates a signal from its path only.
    ///
    /// The address, the last part of the path, determines the direction ([`is_input`]). All other signals are outputs;
    /// they can also be set from outside. The address also determines which analog signals are whole numbers: `B` has 8
    /// bits, `W` 16, `DW` 32 (`%QW4`). It does not contain the sign, so the range covers signed and unsigned numbers.
    #[must_use]
    pub fn from_path(path: &str, digital: bool) -> Self {
        let address = path.rsplit('\\').next().unwrap_or(path);
        Self {
            path: path.to_owned(),
            description: String::new(),
            kind: if digital { SignalKind::Digital } else { SignalKind::Analog(format(address)) },
            direction: if is_input(path) { Direction::Input } else { Direction::Output },
            protected: false,
        }
    }
}

fn format(address: &str) -> SignalRange {
    let letters = address.strip_prefix("%I").or_else(|| address.strip_prefix("%Q")).unwrap_or_default();
    match letters.trim_end_matches(|character: char| character.is_ascii_digit()) {
        "B" => whole(8),
        "W" => whole(16),
        "DW" => whole(32),
        _ => SignalRange::Float,
    }
}

fn whole(bits: i32) -> SignalRange {
    SignalRange::Whole { lowest: -(2_f64.powi(bits - 1)), highest: 2_f64.powi(bits) - 1.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_address_tells_the_direction() {
        let inputs = ["BasicIO-1\\%I0", "usrIn0", "UserIO\\usrIn1", "FastIO\\fIn0", "VirtualIOBoards\\A\\%I2"];
        let outputs =
            ["BasicIO-1\\%Q3", "valve1", "ValveIO\\valve2", "FastIO\\fOut0", "ModbusSrv-0\\Plastics-Bit\\door"];
        assert!(inputs.iter().all(|path| Signal::from_path(path, true).direction == Direction::Input));
        assert!(outputs.iter().all(|path| Signal::from_path(path, true).direction == Direction::Output));
    }

    #[test]
    fn the_address_tells_whole_numbers() {
        let kind = |path| Signal::from_path(path, false).kind;
        let range = |lowest, highest| SignalKind::Analog(SignalRange::Whole { lowest, highest });
        assert_eq!(kind("Board\\%IB56"), range(-128.0, 255.0));
        assert_eq!(kind("Board\\%QW40"), range(-32_768.0, 65_535.0));
        assert_eq!(kind("Board\\%IDW8"), range(-2_147_483_648.0, 4_294_967_295.0));
        for path in ["Board\\%QF8", "ModbusSrv-0\\Modbus-Word\\Weight", "W4"] {
            assert_eq!(kind(path), SignalKind::Analog(SignalRange::Float));
        }
    }

    #[test]
    fn whole_numbers_are_rounded_and_limited() {
        let byte = SignalRange::Whole { lowest: 0.0, highest: 255.0 };
        assert_eq!([12.3, 12.5, -3.0, 300.0].map(|value| byte.fit(value)), [12.0, 13.0, 0.0, 255.0]);
    }
}
