//! Sizes on the command line.

use std::str::FromStr;

/// A number of bytes, written as `4096`, `512K`, `64M` or `2G`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct ByteSize(pub(crate) u64);

impl FromStr for ByteSize {
    type Err = &'static str;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let (number, factor) = match text.char_indices().last() {
            Some((at, 'k' | 'K')) => (text.get(..at), 1 << 10),
            Some((at, 'm' | 'M')) => (text.get(..at), 1 << 20),
            Some((at, 'g' | 'G')) => (text.get(..at), 1 << 30),
            _ => (Some(text), 1),
        };
        let number: Option<u64> = number.and_then(|number| number.parse().ok());
        number
            .and_then(|number| number.checked_mul(factor))
            .map(Self)
            .ok_or("write a number of bytes such as 4096, 512K, 64M or 2G")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_have_units() {
        let bytes = |text: &str| text.parse().map(|ByteSize(bytes)| bytes).ok();
        assert_eq!(["7", "2K", "64m", "1G"].map(bytes), [Some(7), Some(2048), Some(64 << 20), Some(1 << 30)]);
        assert_eq!(["", "M", "1.5G", "-1", "99999999999G"].map(bytes), [None; 5]);
    }
}
