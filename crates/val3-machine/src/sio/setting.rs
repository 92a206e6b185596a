//! Parameters of a channel, from the name and value in a program (3.7.3).

use std::net::IpAddr;

use serde::{Deserialize, Serialize};
use val3_lang::arguments::{SerialFault, SerialParameter};

use super::LineKind;

/// A value that a program passes for a parameter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SettingValue<'v> {
    /// A truth value.
    Bool(bool),
    /// A number.
    Num(f64),
    /// A text.
    Text(&'v str),
    /// Value of any other type, which is invalid for all parameters.
    Other,
}

/// A parameter with its new value.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase")]
pub enum LineSetting {
    /// The TCP or UDP port.
    Port(u16),
    /// The address to call.
    Target(IpAddr),
    /// Maximum number of a server's clients.
    Clients(u16),
    /// The byte that ends a string.
    EndOfString(u8),
    /// Timeout of instructions, in seconds: 0 waits without limit, a negative value does not wait.
    Timeout(f64),
    /// Bits per second.
    BaudRate(u32),
    /// Parity bit.
    Parity(Parity),
    /// Bits a byte, 5 to 8.
    Bits(u8),
    /// Stop bits, 1 or 2.
    StopBits(u8),
    /// Whether the line is RS-422 instead of RS-232.
    Rs422(bool),
    /// Whether hardware flow control is on.
    HardwareFlow(bool),
    /// Whether small packets are collected (Nagle's algorithm).
    Nagle(bool),
}

/// Parity bit on a serial line.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Parity {
    /// No parity bit.
    None,
    /// An even number of ones.
    Even,
    /// An odd number of ones.
    Odd,
}

/// Reason why a name and value are no setting of a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum SettingFault {
    /// -1, -2, -3.
    Argument(SerialFault),
    /// -5: the parameter belongs to another kind of channel.
    Kind,
}

impl LineSetting {
    /// Parses the parameter `name` with its value for a line of this kind; letter case does not count.
    ///
    /// Of several errors, the first in this order is returned: name, kind of channel, type, value.
    pub(super) fn read(name: &str, value: SettingValue<'_>, kind: LineKind) -> Result<Self, SettingFault> {
        let parameter = SerialParameter::find(name).ok_or(SettingFault::Argument(SerialFault::Unknown))?;
        let row = ROWS.iter().find(|row| row.name == parameter.name);
        let row = row.ok_or(SettingFault::Argument(SerialFault::Unknown))?;
        if !row.kinds.contains(&kind) {
            return Err(SettingFault::Kind);
        }
        row.read(parameter, value).map_err(SettingFault::Argument)
    }
}

/// Parameter, the kinds of lines that support it, and the parser for values.
struct SettingRule {
    name: &'static str,
    kinds: &'static [LineKind],
    value: SettingReader,
}

enum SettingReader {
    Truth(fn(bool) -> LineSetting),
    Whole(fn(u32) -> Option<LineSetting>),
    Seconds,
    Text(fn(&str) -> Option<LineSetting>),
}

const TCP: &[LineKind] = &[LineKind::Client, LineKind::Server];
/// UDP came with s8; it supports the parameters that apply to a UDP socket.
const SOCKETS: &[LineKind] = &[LineKind::Client, LineKind::Server, LineKind::Udp];
const CALLERS: &[LineKind] = &[LineKind::Client, LineKind::Udp];
const SERVER: &[LineKind] = &[LineKind::Server];
const SERIAL: &[LineKind] = &[LineKind::Serial];
const ALL: &[LineKind] = &[LineKind::Serial, LineKind::Client, LineKind::Server, LineKind::Udp];

#[rustfmt::skip]
static ROWS: [SettingRule; 12] = [
    SettingRule { name: "port", kinds: SOCKETS, value: SettingReader::Whole(port) },
    SettingRule { name: "target", kinds: CALLERS, value: SettingReader::Text(|text| text.trim().parse().ok().map(LineSetting::Target)) },
    SettingRule { name: "clients", kinds: SERVER, value: SettingReader::Whole(clients) },
    SettingRule { name: "endOfString", kinds: ALL, value: SettingReader::Whole(|value| byte(value).map(LineSetting::EndOfString)) },
    SettingRule { name: "timeout", kinds: ALL, value: SettingReader::Seconds },
    SettingRule { name: "baudRate", kinds: SERIAL, value: SettingReader::Whole(|value| Some(LineSetting::BaudRate(value))) },
    SettingRule { name: "parity", kinds: SERIAL, value: SettingReader::Text(parity) },
    SettingRule { name: "bits", kinds: SERIAL, value: SettingReader::Whole(|value| byte(value).map(LineSetting::Bits)) },
    SettingRule { name: "stopBits", kinds: SERIAL, value: SettingReader::Whole(|value| byte(value).map(LineSetting::StopBits)) },
    SettingRule { name: "mode", kinds: SERIAL, value: SettingReader::Text(|text| Some(LineSetting::Rs422(text.eq_ignore_ascii_case("rs422")))) },
    SettingRule { name: "flowControl", kinds: SERIAL, value: SettingReader::Text(|text| Some(LineSetting::HardwareFlow(text.eq_ignore_ascii_case("hardware")))) },
    SettingRule { name: "nagle", kinds: TCP, value: SettingReader::Truth(LineSetting::Nagle) },
];

impl SettingRule {
    fn read(&self, parameter: &SerialParameter, value: SettingValue<'_>) -> Result<LineSetting, SerialFault> {
        let takes = parameter.value;
        let read = match (&self.value, value) {
            (SettingReader::Truth(read), SettingValue::Bool(value)) => Some(read(value)),
            (SettingReader::Whole(read), SettingValue::Num(value)) if takes.takes_number(value) => {
                whole(value).and_then(read)
            }
            (SettingReader::Seconds, SettingValue::Num(value)) => {
                value.is_finite().then_some(LineSetting::Timeout(value))
            }
            (SettingReader::Text(read), SettingValue::Text(text)) if takes.takes_text(text) => read(text),
            (SettingReader::Whole(_), SettingValue::Num(_)) | (SettingReader::Text(_), SettingValue::Text(_)) => None,
            _ => return Err(SerialFault::Type),
        };
        read.ok_or(SerialFault::Value)
    }
}

fn port(value: u32) -> Option<LineSetting> {
    u16::try_from(value).ok().filter(|port| *port != 0).map(LineSetting::Port)
}

fn clients(value: u32) -> Option<LineSetting> {
    u16::try_from(value).ok().filter(|clients| *clients != 0).map(LineSetting::Clients)
}

fn parity(text: &str) -> Option<LineSetting> {
    let named = [("none", Parity::None), ("even", Parity::Even), ("odd", Parity::Odd)];
    let found = named.into_iter().find(|(name, _)| text.eq_ignore_ascii_case(name));
    found.map(|(_, parity)| LineSetting::Parity(parity))
}

fn byte(value: u32) -> Option<u8> {
    u8::try_from(value).ok()
}

/// Converts a number that is a whole number.
fn whole(value: f64) -> Option<u32> {
    let fits = value.fract() == 0.0 && (0.0..=f64::from(u32::MAX)).contains(&value);
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "it is whole and fits")]
    fits.then_some(value as u32)
}

#[cfg(test)]
mod tests {
    use val3_lang::arguments::SERIAL_PARAMETERS;

    use super::*;

    fn read(kind: LineKind, name: &str, value: SettingValue<'_>) -> Result<LineSetting, i8> {
        LineSetting::read(name, value, kind).map_err(|fault| match fault {
            SettingFault::Argument(fault) => fault.result(),
            SettingFault::Kind => -5,
        })
    }

    #[test]
    fn every_parameter_has_a_row() {
        assert!(SERIAL_PARAMETERS.iter().all(|parameter| ROWS.iter().any(|row| row.name == parameter.name)));
    }

    #[test]
    fn the_example_of_the_manual() {
        let serial = |name, value| read(LineKind::Serial, name, value).unwrap();
        assert_eq!(serial("baudRate", SettingValue::Num(115_200.0)), LineSetting::BaudRate(115_200));
        assert_eq!(serial("bits", SettingValue::Num(8.0)), LineSetting::Bits(8));
        assert_eq!(serial("parity", SettingValue::Text("none")), LineSetting::Parity(Parity::None));
        assert_eq!(serial("stopBits", SettingValue::Num(1.0)), LineSetting::StopBits(1));
        assert_eq!(serial("timeout", SettingValue::Num(0.0)), LineSetting::Timeout(0.0));
        assert_eq!(serial("endOfString", SettingValue::Num(13.0)), LineSetting::EndOfString(13));
    }

    #[test]
    fn wrong_parameters_have_a_number() {
        let server = |name, value| read(LineKind::Server, name, value).unwrap_err();
        assert_eq!(server("speed", SettingValue::Num(1.0)), -1);
        assert_eq!(server("port", SettingValue::Text("80")), -2);
        assert_eq!(server("nagle", SettingValue::Num(1.0)), -2);
        assert_eq!(server("endOfString", SettingValue::Other), -2);
        for port in [0.0, 65_536.0, -1.0, 80.5, f64::NAN] {
            assert_eq!(server("port", SettingValue::Num(port)), -3, "{port}");
        }
        assert_eq!(server("endOfString", SettingValue::Num(256.0)), -3);
        assert_eq!(server("clients", SettingValue::Num(0.0)), -3);
        assert_eq!(server("baudRate", SettingValue::Num(9600.0)), -5);
        assert_eq!(server("target", SettingValue::Text("127.0.0.1")), -5);
    }

    #[test]
    fn each_kind_has_parameters_of_its_own() {
        let client = |name, value| read(LineKind::Client, name, value);
        assert_eq!(client("Target", SettingValue::Text("nowhere")), Err(-3));
        assert!(client("TARGET", SettingValue::Text("192.168.0.254")).is_ok());
        assert_eq!(client("clients", SettingValue::Num(1.0)), Err(-5));
        let serial = |name, value| read(LineKind::Serial, name, value);
        assert_eq!(serial("port", SettingValue::Num(80.0)), Err(-5));
        assert_eq!(serial("parity", SettingValue::Text("mark")), Err(-3));
        assert_eq!(serial("bits", SettingValue::Num(9.0)), Err(-3));
        assert_eq!(serial("nagle", SettingValue::Bool(true)), Err(-5));
    }

    #[test]
    fn a_negative_timeout_is_taken() {
        let timeout = |value| read(LineKind::Server, "timeout", SettingValue::Num(value));
        assert_eq!(timeout(-1.0), Ok(LineSetting::Timeout(-1.0)));
        assert_eq!(timeout(0.5), Ok(LineSetting::Timeout(0.5)));
        assert_eq!(timeout(f64::INFINITY), Err(-3));
    }
}
