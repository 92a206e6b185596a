//! Input for a waiting `get`, and its end (4.3).

use val3_lang::keys;
use val3_lang::ports::{InputKind, InputResult, OperatorInput};

use super::line_editor::LineEditor;

/// Waiting `get`.
#[derive(Debug, Clone)]
pub(super) struct ScreenReading {
    asked: InputKind,
    editor: Option<LineEditor>,
}

/// The effect of a key on a `get`.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum KeyEffect {
    /// No visible effect.
    Nothing,
    /// The text of the entry changed.
    Edited,
    /// The `get` has ended.
    Ended(InputResult),
}

impl ScreenReading {
    pub(super) fn new(asked: InputKind) -> Self {
        let editor = match &asked {
            InputKind::Key | InputKind::Confirmation => None,
            InputKind::Text(text) => Some(LineEditor::new(text, |_| true)),
            InputKind::Number { shown, .. } => Some(LineEditor::new(shown, of_a_number)),
        };
        Self { asked, editor }
    }

    /// Displayed text, if the `get` has an entry.
    pub(super) fn shown(&self) -> Option<String> {
        self.editor.as_ref().map(LineEditor::text)
    }

    /// Processes a key of the operator.
    pub(super) fn press(&mut self, key: u16) -> KeyEffect {
        if self.asked == InputKind::Key {
            return KeyEffect::Ended(InputResult { key, entry: OperatorInput::Unchanged });
        }
        match key {
            keys::ESC => {
                *self = Self::new(self.asked.clone());
                KeyEffect::Ended(InputResult { key, entry: OperatorInput::Unchanged })
            }
            _ if key == keys::RETURN || keys::is_menu(key) => {
                KeyEffect::Ended(InputResult { key, entry: self.entry() })
            }
            _ => self.edit(key),
        }
    }

    /// A single 0 is replaced by the typed character, so that a sign or a point may follow.
    fn edit(&mut self, key: u16) -> KeyEffect {
        let Some(editor) = &mut self.editor else { return KeyEffect::Nothing };
        let types_number = keys::character(key).is_some_and(of_a_number);
        if matches!(self.asked, InputKind::Number { .. }) && types_number && editor.text() == "0" {
            *editor = LineEditor::new("", of_a_number);
        }
        if editor.press(key) { KeyEffect::Edited } else { KeyEffect::Nothing }
    }

    /// Accepted value. An unedited number keeps its hidden digits; a text that is no number, such as an empty entry,
    /// does not change the variable.
    fn entry(&self) -> OperatorInput {
        let text = self.shown().unwrap_or_default();
        match &self.asked {
            InputKind::Key | InputKind::Confirmation => OperatorInput::Unchanged,
            InputKind::Text(_) => OperatorInput::Text(text),
            InputKind::Number { value, shown } if *shown == text => OperatorInput::Number(*value),
            InputKind::Number { .. } => match text.parse::<f64>() {
                Ok(number) if number.is_finite() => OperatorInput::Number(number),
                _ => OperatorInput::Unchanged,
            },
        }
    }
}

fn of_a_number(character: char) -> bool {
    character.is_ascii_digit() || "+-.eE".contains(character)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn number(value: f64, shown: &str) -> InputKind {
        InputKind::Number { value, shown: shown.to_owned() }
    }

    /// Returns the text at the end and the result of the `get`, if the last key has ended it.
    fn read(asked: InputKind, codes: &[u16]) -> (Option<String>, Option<InputResult>) {
        let mut reading = ScreenReading::new(asked);
        let mut answer = None;
        for code in codes {
            assert_eq!(answer, None, "it ended before {code}");
            if let KeyEffect::Ended(ended) = reading.press(*code) {
                answer = Some(ended);
            }
        }
        (reading.shown(), answer)
    }

    fn answer(key: u16, entry: OperatorInput) -> Option<InputResult> {
        Some(InputResult { key, entry })
    }

    #[test]
    fn any_key_ends_a_get_without_a_variable() {
        for key in [97, 255, 263, 270, 278, 283] {
            assert_eq!(read(InputKind::Key, &[key]), (None, answer(key, OperatorInput::Unchanged)));
        }
    }

    #[test]
    fn a_question_is_answered_with_yes_or_no() {
        let (_, yes) = read(InputKind::Confirmation, &[97, 281, 270]);
        let (_, no) = read(InputKind::Confirmation, &[255]);
        assert_eq!((yes.unwrap().is_accepted(), no.unwrap().is_accepted()), (true, false));
    }

    #[test]
    fn return_and_the_menu_keys_accept_a_text() {
        for key in [270, 271, 278] {
            let (shown, ended) = read(InputKind::Text("ab".to_owned()), &[99, key]);
            assert_eq!((shown.as_deref(), ended), (Some("abc"), answer(key, OperatorInput::Text("abc".to_owned()))));
        }
    }

    #[test]
    fn esc_leaves_the_variable() {
        let (shown, ended) = read(InputKind::Text("ab".to_owned()), &[99, 255]);
        assert_eq!((shown.as_deref(), ended), (Some("ab"), answer(255, OperatorInput::Unchanged)));
    }

    #[test]
    fn other_keys_do_not_end_an_entry() {
        assert_eq!(read(InputKind::Text(String::new()), &[281, 259, 261, 263]), (Some(String::new()), None));
    }

    #[test]
    fn a_number_is_edited_as_text() {
        assert_eq!(read(number(1.0, "1"), &[50, 46, 53, 270]).1, answer(270, OperatorInput::Number(12.5)));
        assert_eq!(read(number(0.0, "0"), &[53, 270]).1, answer(270, OperatorInput::Number(5.0)));
        assert_eq!(read(number(0.0, "0"), &[45, 46, 53, 270]).1, answer(270, OperatorInput::Number(-0.5)));
        assert_eq!(read(number(0.0, "0"), &[263, 48, 270]).1, answer(270, OperatorInput::Number(0.0)));
        assert_eq!(read(number(5.0, "5"), &[265, 45, 270]).1, answer(270, OperatorInput::Number(-5.0)));
    }

    #[test]
    fn a_number_takes_no_letters() {
        assert_eq!(read(number(1.0, "1"), &[97, 32, 50, 270]).1, answer(270, OperatorInput::Number(12.0)));
    }

    #[test]
    fn an_entry_that_is_no_number_leaves_the_variable() {
        assert_eq!(read(number(1.0, "1"), &[263, 270]).1, answer(270, OperatorInput::Unchanged));
        assert_eq!(read(number(1.0, "1"), &[45, 270]).1, answer(270, OperatorInput::Unchanged));
        assert_eq!(read(number(1.0, "1"), &[101, 57, 57, 57, 270]).1, answer(270, OperatorInput::Unchanged));
    }

    #[test]
    fn an_untouched_number_keeps_all_its_digits() {
        assert_eq!(read(number(1.000_04, "1"), &[270]).1, answer(270, OperatorInput::Number(1.000_04)));
    }
}
