//! Item addresses: the `Syntaxe`, such as `%Q0`, `%I10:8` or `%QW0:2`.

use crate::{TableKind, Writer};

/// Number of addresses in each table.
pub(super) const ADDRESSES: u32 = 0x1_0000;

/// Parsed `Syntaxe`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct ItemSyntax {
    pub(super) writer: Writer,
    /// First address, from 0.
    pub(super) first: u16,
    /// Array size in addresses, 1 to 65536; `None` for a single value.
    pub(super) count: Option<u32>,
}

impl ItemSyntax {
    /// Parses a text of this table; `None` if it has another form, or addresses beyond the table.
    pub(super) fn parse(text: &str, table: TableKind) -> Option<Self> {
        let letters = text.trim().strip_prefix('%')?;
        let (writer, rest) = match letters.strip_prefix('Q') {
            Some(rest) => (Writer::Client, rest),
            None => (Writer::Robot, letters.strip_prefix('I')?),
        };
        let addresses = rest.strip_prefix(table.letters())?;
        let (first, count) = match addresses.split_once(':') {
            Some((first, count)) => (first, Some(number(count)?)),
            None => (addresses, None),
        };
        let first = u16::try_from(number(first)?).ok()?;
        let end = u32::from(first).checked_add(count.unwrap_or(1))?;
        (count != Some(0) && end <= ADDRESSES).then_some(Self { writer, first, count })
    }
}

/// Parses a number without a sign.
fn number(text: &str) -> Option<u32> {
    let text = text.trim();
    text.bytes().all(|byte| byte.is_ascii_digit()).then(|| text.parse().ok()).flatten()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn letters_and_numbers_are_read() {
        let parse = |text, table| ItemSyntax::parse(text, table).map(|item| (item.writer, item.first, item.count));
        assert_eq!(parse("%Q0", TableKind::Bits), Some((Writer::Client, 0, None)));
        assert_eq!(parse(" %I10:8 ", TableKind::Bits), Some((Writer::Robot, 10, Some(8))));
        assert_eq!(parse("%QW0:2", TableKind::Words), Some((Writer::Client, 0, Some(2))));
        assert_eq!(parse("%I0:65536", TableKind::Bits), Some((Writer::Robot, 0, Some(65_536))));
        for text in ["", "Q0", "%X0", "%Q", "%Q-1", "%Q+1", "%QW0", "%Q1:0", "%Q1:65536", "%Q1:4000000000", "%Q65536"] {
            assert_eq!(parse(text, TableKind::Bits), None, "{text}");
        }
        assert_eq!(parse("%Q0", TableKind::Words), None);
    }
}
