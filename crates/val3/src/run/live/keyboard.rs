//! Maps keyboard keys to pendant keys (12.2).

use ratatui::crossterm::event::{KeyCode, KeyEvent, KeyEventKind, KeyModifiers};
use val3_lang::keys::{KEYS, character};

/// Effect of a keyboard key.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum KeyCommand {
    /// Presses and releases the pendant key with this code, because terminals do not report the release of keys.
    Tap(u16),
    /// User-Down.
    NextPage,
    /// User-Up.
    PreviousPage,
    /// Ctrl-C.
    Interrupt,
}

/// Effect of a key, if it has one.
pub(super) fn command(key: KeyEvent) -> Option<KeyCommand> {
    if key.kind == KeyEventKind::Release {
        return None;
    }
    match key.code {
        KeyCode::Char('c' | 'C') if key.modifiers.contains(KeyModifiers::CONTROL) => Some(KeyCommand::Interrupt),
        KeyCode::F(9) => Some(KeyCommand::PreviousPage),
        KeyCode::F(10) => Some(KeyCommand::NextPage),
        KeyCode::Char(written) => typed(written, key.modifiers).map(KeyCommand::Tap),
        KeyCode::F(number) => named(&format!("F{number}")).map(KeyCommand::Tap),
        code => name(code).and_then(named).map(KeyCommand::Tap),
    }
}

/// Pendant key for a typed character. With Alt, 1 to 3 are the pendant keys without a character. Control and Alt
/// together are AltGr in some terminals.
fn typed(written: char, modifiers: KeyModifiers) -> Option<u16> {
    let held = modifiers & (KeyModifiers::CONTROL | KeyModifiers::ALT);
    if held == KeyModifiers::ALT {
        return named(written.encode_utf8(&mut [0; 4]));
    }
    let code = u16::try_from(u32::from(written)).ok()?;
    (held != KeyModifiers::CONTROL && character(code).is_some()).then_some(code)
}

/// Label of the pendant key.
fn name(code: KeyCode) -> Option<&'static str> {
    Some(match code {
        KeyCode::Enter => "Return",
        KeyCode::Esc => "Esc",
        KeyCode::Tab => "Tab",
        KeyCode::BackTab => "UnTab",
        KeyCode::Backspace | KeyCode::Delete => "Bksp",
        KeyCode::Up => "Up",
        KeyCode::Down => "Down",
        KeyCode::Left => "Left",
        KeyCode::Right => "Right",
        KeyCode::PageUp => "PgUp",
        KeyCode::PageDown => "PgDn",
        KeyCode::Home => "Home",
        KeyCode::End => "End",
        _ => return None,
    })
}

fn named(name: &str) -> Option<u16> {
    KEYS.iter().find(|key| key.name == name).map(|key| key.code)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tapped(code: KeyCode, modifiers: KeyModifiers) -> Option<u16> {
        match command(KeyEvent::new(code, modifiers))? {
            KeyCommand::Tap(code) => Some(code),
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn every_key_of_the_pendant_is_on_the_keyboard() {
        let named = [
            KeyCode::Esc,
            KeyCode::Tab,
            KeyCode::BackTab,
            KeyCode::Up,
            KeyCode::PageUp,
            KeyCode::Backspace,
            KeyCode::Left,
            KeyCode::Home,
            KeyCode::Down,
            KeyCode::PageDown,
            KeyCode::Right,
            KeyCode::End,
            KeyCode::Enter,
        ];
        let plain = named.into_iter().chain((1..=8).map(KeyCode::F)).map(|code| tapped(code, KeyModifiers::NONE));
        let user = ['1', '2', '3'].map(|digit| tapped(KeyCode::Char(digit), KeyModifiers::ALT));
        let reached: Vec<_> = plain.chain(user).collect();
        assert_eq!(reached, KEYS.iter().map(|key| Some(key.code)).collect::<Vec<_>>());
    }

    #[test]
    fn characters_are_typed() {
        for (written, code) in [('a', 97), ('A', 65), ('1', 49), (' ', 32), ('é', 233), ('中', 0x4e2d)] {
            assert_eq!(tapped(KeyCode::Char(written), KeyModifiers::SHIFT), Some(code), "{written}");
        }
        assert_eq!(tapped(KeyCode::Char('@'), KeyModifiers::CONTROL | KeyModifiers::ALT), Some(64));
    }

    #[test]
    fn other_keys_do_nothing() {
        assert_eq!(tapped(KeyCode::Char('a'), KeyModifiers::CONTROL), None);
        assert_eq!(tapped(KeyCode::Char('a'), KeyModifiers::ALT), None);
        assert_eq!(tapped(KeyCode::Char('\u{1f600}'), KeyModifiers::NONE), None);
        assert_eq!(tapped(KeyCode::F(11), KeyModifiers::NONE), None);
        let up = KeyEvent::new_with_kind(KeyCode::Enter, KeyModifiers::NONE, KeyEventKind::Release);
        assert_eq!(command(up), None);
    }

    #[test]
    fn some_keys_are_for_the_run_itself() {
        let does = |code, modifiers| command(KeyEvent::new(code, modifiers));
        assert_eq!(does(KeyCode::Char('c'), KeyModifiers::CONTROL), Some(KeyCommand::Interrupt));
        assert_eq!(does(KeyCode::F(9), KeyModifiers::NONE), Some(KeyCommand::PreviousPage));
        assert_eq!(does(KeyCode::F(10), KeyModifiers::NONE), Some(KeyCommand::NextPage));
    }
}
