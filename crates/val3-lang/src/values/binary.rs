//! Numbers as bytes for other devices: `toBinary` and `fromBinary` (3.3.3).
//!
//! A number that is out of its format's range is replaced by the nearest number in the range, rounded as by `round` if
//! the format contains only whole numbers. Encoded numbers can therefore always be decoded.

use super::numbers::{count, round};
use crate::fault::{Fault, Result};

/// Binary format of a number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct BinaryFormat {
    encoding: Encoding,
    order: ByteOrder,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Encoding {
    /// Unsigned integer with this number of bytes.
    Unsigned(u8),
    /// Signed integer with this number of bytes, two's complement.
    Signed(u8),
    /// IEEE 754, 4 bytes.
    Single,
    /// IEEE 754, 8 bytes.
    Double,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum ByteOrder {
    LowFirst,
    HighFirst,
}

/// `toBinary`: encodes the first `size` numbers and returns the number of bytes; `size` is rounded like an index.
///
/// # Errors
/// 70, without writing: `size` is negative or exceeds the numbers, the format is unknown, or `bytes` is too small.
pub fn to_binary(values: &[f64], size: f64, format: &str, bytes: &mut [f64]) -> Result<f64> {
    let format = BinaryFormat::parse(format)?;
    let values = values.get(..count(size)?).ok_or(Fault::INVALID_PARAMETER)?;
    let encoded = bytes.get_mut(..values.len() * format.width()).ok_or(Fault::INVALID_PARAMETER)?;
    for (value, bytes) in values.iter().zip(encoded.chunks_exact_mut(format.width())) {
        for (byte, encoded) in bytes.iter_mut().zip(format.encode(*value)) {
            *byte = f64::from(encoded);
        }
    }
    Ok(encoded.len() as f64)
}

/// `fromBinary`: decodes the first `size` bytes and returns the number of decoded numbers.
///
/// Bytes whose rounded value is not 0 to 255, and encodings of infinity and NaN, are corrupt. The first corrupt number
/// ends the decoding: the result is the negative number of decoded numbers, and the other `values` are unchanged. An
/// incomplete number at the end is ignored. `size` is rounded like an index.
///
/// # Errors
/// 70, without writing: `size` is negative or exceeds the bytes, the format is unknown, or `values` is too small.
pub fn from_binary(bytes: &[f64], size: f64, format: &str, values: &mut [f64]) -> Result<f64> {
    let format = BinaryFormat::parse(format)?;
    let bytes = bytes.get(..count(size)?).ok_or(Fault::INVALID_PARAMETER)?.chunks_exact(format.width());
    let values = values.get_mut(..bytes.len()).ok_or(Fault::INVALID_PARAMETER)?;
    for (decoded, (bytes, value)) in bytes.zip(values.iter_mut()).enumerate() {
        match format.decode(bytes) {
            Some(number) => *value = number,
            None => return Ok(0.0 - decoded as f64),
        }
    }
    Ok(values.len() as f64)
}

impl BinaryFormat {
    /// Parses the name of a format.
    ///
    /// # Errors
    /// 70 for an unknown format name; 14 formats exist.
    pub fn parse(name: &str) -> Result<Self> {
        use ByteOrder::{HighFirst, LowFirst};
        use Encoding::{Double, Signed, Single, Unsigned};
        let (encoding, order) = match name {
            "-1" => (Signed(1), LowFirst),
            "1" => (Unsigned(1), LowFirst),
            "-2l" => (Signed(2), LowFirst),
            "-2b" => (Signed(2), HighFirst),
            "2l" => (Unsigned(2), LowFirst),
            "2b" => (Unsigned(2), HighFirst),
            "-4l" => (Signed(4), LowFirst),
            "-4b" => (Signed(4), HighFirst),
            "4l" => (Unsigned(4), LowFirst),
            "4b" => (Unsigned(4), HighFirst),
            "4.0l" => (Single, LowFirst),
            "4.0b" => (Single, HighFirst),
            "8.0l" => (Double, LowFirst),
            "8.0b" => (Double, HighFirst),
            _ => return Err(Fault::INVALID_PARAMETER),
        };
        Ok(Self { encoding, order })
    }

    /// Encoded size in bytes.
    #[must_use]
    pub fn width(self) -> usize {
        match self.encoding {
            Encoding::Unsigned(width) | Encoding::Signed(width) => usize::from(width),
            Encoding::Single => 4,
            Encoding::Double => 8,
        }
    }

    /// Whether the format can represent the number, up to the rounding of floating-point formats.
    #[must_use]
    pub fn holds(self, value: f64) -> bool {
        match self.encoding {
            Encoding::Unsigned(_) | Encoding::Signed(_) => self.number(self.bits(value)) == value,
            Encoding::Single => value.abs() <= f64::from(f32::MAX),
            Encoding::Double => value.is_finite(),
        }
    }

    /// Encodes a number.
    pub fn encode(self, value: f64) -> impl Iterator<Item = u8> {
        let width = self.width();
        let low_first = self.bits(value).to_le_bytes();
        (0..width).filter_map(move |at| low_first.get(self.place(at, width)).copied())
    }

    /// Decodes a number from bytes, each of which is rounded; `None` if they are corrupt.
    #[must_use]
    pub fn decode(self, bytes: &[f64]) -> Option<f64> {
        let mut low_first = [0; 8];
        for (at, &byte) in bytes.iter().enumerate() {
            *low_first.get_mut(self.place(at, bytes.len()))? = whole_byte(byte)?;
        }
        Some(self.number(u64::from_le_bytes(low_first))).filter(|number| number.is_finite())
    }

    /// Index of byte `at` in little-endian order.
    fn place(self, at: usize, width: usize) -> usize {
        match self.order {
            ByteOrder::LowFirst => at,
            ByteOrder::HighFirst => width - 1 - at,
        }
    }

    /// Encoding of a number in the low bits.
    fn bits(self, value: f64) -> u64 {
        match self.encoding {
            Encoding::Unsigned(width) => (round(value) as u64).min(u64::MAX >> unused_bits(width)),
            Encoding::Signed(width) => {
                let largest = i64::MAX >> unused_bits(width);
                (round(value) as i64).clamp(-largest - 1, largest).cast_unsigned()
            }
            Encoding::Single => u64::from((value.clamp(f64::from(f32::MIN), f64::from(f32::MAX)) as f32).to_bits()),
            Encoding::Double => value.to_bits(),
        }
    }

    /// Number that is encoded in the low bits; the other bits are 0.
    fn number(self, bits: u64) -> f64 {
        match self.encoding {
            Encoding::Unsigned(_) => bits as f64,
            Encoding::Signed(width) => ((bits << unused_bits(width)).cast_signed() >> unused_bits(width)) as f64,
            Encoding::Single => f64::from(f32::from_bits(bits as u32)),
            Encoding::Double => f64::from_bits(bits),
        }
    }
}

/// Number of bits in a `u64` that `width` bytes do not use.
fn unused_bits(width: u8) -> u32 {
    64 - 8 * u32::from(width)
}

fn whole_byte(value: f64) -> Option<u8> {
    let whole = round(value);
    (0.0..=255.0).contains(&whole).then_some(whole as u8)
}

#[cfg(test)]
mod tests;
