//! Keys of the pendant that are held down.

use std::collections::BTreeMap;

/// Time for which a tapped key is held down, in nanoseconds: 100 ms.
pub const TAP: u64 = 100_000_000;

/// Pressed keys with their release times.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) struct Keyboard {
    down: BTreeMap<u16, Option<u64>>,
}

impl Keyboard {
    /// Presses a key, until `release` or, for a tap, until a time.
    pub(super) fn press(&mut self, code: u16, until: Option<u64>) {
        self.down.insert(code, until);
    }

    pub(super) fn release(&mut self, code: u16) {
        self.down.remove(&code);
    }

    pub(super) fn is_down(&self, code: u16) -> bool {
        self.down.contains_key(&code)
    }

    /// Releases the tapped keys that are due.
    pub(super) fn advance(&mut self, now: u64) {
        self.down.retain(|_, until| until.is_none_or(|until| now < until));
    }

    /// Time of the next release of a tapped key.
    pub(super) fn next_release(&self) -> Option<u64> {
        self.down.values().copied().flatten().min()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_tapped_key_comes_up_by_itself() {
        let mut keyboard = Keyboard::default();
        keyboard.press(97, Some(TAP));
        keyboard.press(98, None);
        keyboard.advance(TAP - 1);
        assert!(keyboard.is_down(97));
        assert_eq!(keyboard.next_release(), Some(TAP));
        keyboard.advance(TAP);
        assert!(!keyboard.is_down(97) && keyboard.is_down(98));
        assert_eq!(keyboard.next_release(), None);
        keyboard.release(98);
        assert!(!keyboard.is_down(98));
    }
}
