//! Keys of the pendant without a character (12.2).

/// A key.
#[derive(Debug, PartialEq, Eq)]
pub struct PendantKey {
    /// Code returned by `get` and `getKey`.
    pub code: u16,
    /// Label.
    pub name: &'static str,
}

/// Closes a pop-up, or cancels an entry (4.3).
pub const ESC: u16 = 255;

/// Deletes the character before the cursor.
pub const BACKSPACE: u16 = 263;

/// Moves one character to the left.
pub const LEFT: u16 = 264;

/// Moves to the start of the line.
pub const HOME: u16 = 265;

/// Moves one character to the right.
pub const RIGHT: u16 = 268;

/// Moves to the end of the line.
pub const END: u16 = 269;

/// Accepts an entry.
pub const RETURN: u16 = 270;

/// Whether the code is one of F1 to F8, the keys under the menu line, which accept an entry as [`RETURN`] does.
#[must_use]
pub fn is_menu(code: u16) -> bool {
    (271..=278).contains(&code)
}

/// Whether the code is one of the keys 1, 2 and 3, which programs receive regardless of the displayed page (4.3).
#[must_use]
pub fn is_always_seen(code: u16) -> bool {
    (281..=283).contains(&code)
}

/// Character of a key, if it has one; its code is the character's code point.
#[must_use]
pub fn character(code: u16) -> Option<char> {
    let written = (32..=126).contains(&code) || (code >= 160 && !(255..=283).contains(&code));
    char::from_u32(code.into()).filter(|_| written)
}

const fn row(code: u16, name: &'static str) -> PendantKey {
    PendantKey { code, name }
}

/// All keys without a character, ascending.
pub static KEYS: [PendantKey; 24] = [
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
