//! The keys of the pendant that have no character of their own (12.2).

/// One key.
#[derive(Debug, PartialEq, Eq)]
pub struct Key {
    /// The code that `get` and `getKey` give.
    pub code: u16,
    /// Its label.
    pub name: &'static str,
}

/// Leaves what was begun; it closes a pop-up and ends an entry without a change (4.3).
pub const ESC: u16 = 255;

/// Deletes the character before the place of editing.
pub const BACKSPACE: u16 = 263;

/// One character to the left.
pub const LEFT: u16 = 264;

/// To the beginning of the line.
pub const HOME: u16 = 265;

/// One character to the right.
pub const RIGHT: u16 = 268;

/// To the end of the line.
pub const END: u16 = 269;

/// Accepts an entry.
pub const RETURN: u16 = 270;

/// F1 to F8, the keys under the menu line; each accepts an entry as [`RETURN`] does.
#[must_use]
pub fn is_menu(code: u16) -> bool {
    (271..=278).contains(&code)
}

/// The keys 1, 2 and 3, which are seen whatever the pendant shows (4.3).
#[must_use]
pub fn is_always_seen(code: u16) -> bool {
    (281..=283).contains(&code)
}

/// The character that a key writes, if it writes one; its code is the character's code point.
#[must_use]
pub fn character(code: u16) -> Option<char> {
    let written = (32..=126).contains(&code) || (code >= 160 && !(255..=283).contains(&code));
    char::from_u32(code.into()).filter(|_| written)
}

const fn row(code: u16, name: &'static str) -> Key {
    Key { code, name }
}

/// Every such key, ascending.
pub static KEYS: [Key; 24] = [
    row(ESC, "Esc"),
    row(259, "Tab"),
    row(260, "UnTab"),
    row(261, "Up"),
    row(262, "PgUp"),
    row(BACKSPACE, "Bksp"),
    row(LEFT, "Left"),
    row(HOME, "Home"),
    row(266, "Down"),
    row(267, "PgDn"),
    row(RIGHT, "Right"),
    row(END, "End"),
    row(RETURN, "Return"),
    row(271, "F1"),
    row(272, "F2"),
    row(273, "F3"),
    row(274, "F4"),
    row(275, "F5"),
    row(276, "F6"),
    row(277, "F7"),
    row(278, "F8"),
    row(281, "1"),
    row(282, "2"),
    row(283, "3"),
];

#[cfg(test)]
mod tests {
    use super::{KEYS, character, is_menu};

    #[test]
    fn each_key_has_a_code_of_its_own() {
        assert!(KEYS.is_sorted_by(|a, b| a.code < b.code));
    }

    #[test]
    fn a_key_writes_its_character_or_has_a_name() {
        assert_eq!((character(97), character(32), character(0x4e2d)), (Some('a'), Some(' '), Some('中')));
        assert!(KEYS.iter().all(|key| character(key.code).is_none()));
        assert_eq!((character(8), character(127)), (None, None));
    }

    #[test]
    fn the_menu_has_eight_keys() {
        let menu: Vec<_> = KEYS.iter().filter(|key| is_menu(key.code)).map(|key| key.name).collect();
        assert_eq!(menu, ["F1", "F2", "F3", "F4", "F5", "F6", "F7", "F8"]);
    }
}
