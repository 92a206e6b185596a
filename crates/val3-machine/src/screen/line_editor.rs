//! Line of text that the operator edits (`get`, 4.3).

use val3_lang::keys;

/// Maximum size of the text in bytes, as for a string variable.
const LONGEST: usize = 128;

/// Text with a cursor.
///
/// The manual does not name the keys that edit. Here a character is inserted at the cursor, which is initially at the
/// end; Bksp deletes the character before it; Left, Right, Home and End move it. Other keys have no effect.
#[derive(Debug, Clone)]
pub(super) struct LineEditor {
    before: String,
    after: String,
    accepts: fn(char) -> bool,
}

impl LineEditor {
    /// Edits `text`; characters that `accepts` rejects cannot be typed.
    pub(super) fn new(text: &str, accepts: fn(char) -> bool) -> Self {
        Self { before: text.to_owned(), after: String::new(), accepts }
    }

    /// Complete text.
    pub(super) fn text(&self) -> String {
        format!("{}{}", self.before, self.after)
    }

    /// Applies a key; returns whether the text has changed.
    pub(super) fn press(&mut self, code: u16) -> bool {
        match code {
            keys::BACKSPACE => self.before.pop().is_some(),
            keys::LEFT => self.left(),
            keys::RIGHT => self.right(),
            keys::HOME => {
                self.after.insert_str(0, &std::mem::take(&mut self.before));
                false
            }
            keys::END => {
                self.before.push_str(&std::mem::take(&mut self.after));
                false
            }
            _ => keys::character(code).is_some_and(|character| self.insert(character)),
        }
    }

    fn left(&mut self) -> bool {
        if let Some(character) = self.before.pop() {
            self.after.insert(0, character);
        }
        false
    }

    fn right(&mut self) -> bool {
        if !self.after.is_empty() {
            self.before.push(self.after.remove(0));
        }
        false
    }

    fn insert(&mut self, character: char) -> bool {
        let fits = self.before.len() + self.after.len() + character.len_utf8() <= LONGEST;
        let taken = fits && (self.accepts)(character);
        if taken {
            self.before.push(character);
        }
        taken
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn edited(text: &str, codes: &[u16]) -> String {
        let mut editor = LineEditor::new(text, |_| true);
        for code in codes {
            editor.press(*code);
        }
        editor.text()
    }

    #[test]
    fn characters_go_to_the_end() {
        assert_eq!(edited("ab", &[99, 32, 100]), "abc d");
    }

    #[test]
    fn the_place_of_editing_moves() {
        assert_eq!(edited("ab", &[264, 120]), "axb");
        assert_eq!(edited("ab", &[265, 120, 269, 121]), "xaby");
        assert_eq!(edited("ab", &[264, 264, 264, 268, 120]), "axb");
    }

    #[test]
    fn backspace_deletes_before_it() {
        assert_eq!(edited("中é", &[263]), "中");
        assert_eq!(edited("ab", &[264, 263, 263]), "b");
        assert_eq!(edited("", &[263]), "");
    }

    #[test]
    fn other_keys_do_nothing() {
        assert_eq!(edited("ab", &[259, 260, 261, 262, 266, 267, 281, 7]), "ab");
    }

    #[test]
    fn a_string_holds_128_bytes() {
        assert_eq!(edited(&"x".repeat(127), &[97, 98]).len(), 128);
        assert_eq!(edited(&"x".repeat(127), &[0x4e2d, 98]), format!("{}b", "x".repeat(127)));
    }
}
