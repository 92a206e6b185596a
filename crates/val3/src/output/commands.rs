//! Commands of continuous integration services in the output of a step.
//!
//! GitHub Actions executes a line that begins with `::` after blanks, and `##[…]` anywhere in a line; Azure Pipelines
//! and TeamCity execute `##vso[…]` and `##teamcity[…]`. The services compare texts by linguistic rules, which ignore
//! invisible characters.

/// Environment variables that the services set.
const SERVICES: [&str; 3] = ["GITHUB_ACTIONS", "TF_BUILD", "TEAMCITY_VERSION"];

/// Whether a service reads the output.
pub(super) fn are_read() -> bool {
    SERVICES.iter().any(|name| std::env::var_os(name).is_some_and(|value| !value.is_empty()))
}

/// Finds the characters that complete the first characters of a command.
#[derive(Debug, Default)]
pub(super) struct CommandSearch {
    line: LineStart,
    hashes: Hashes,
}

/// Visible characters of the line so far.
#[derive(Debug, Default, Clone, Copy, PartialEq, Eq)]
enum LineStart {
    #[default]
    Blank,
    Colon,
    Other,
}

/// Preceding characters, as a prefix of `##word[`.
#[derive(Debug, Default, Clone, Copy, PartialEq, Eq)]
enum Hashes {
    #[default]
    None,
    One,
    /// Two hashes, possibly followed by letters.
    Two,
}

impl CommandSearch {
    /// Whether the next character of the output completes the first characters of a command.
    pub(super) fn completes(&mut self, character: char) -> bool {
        if matches!(character, '\r' | '\n') {
            *self = Self::default();
            return false;
        }
        if is_invisible(character) {
            return false;
        }
        let completes_colons = self.line == LineStart::Colon && character == ':';
        let completes_hashes = self.hashes == Hashes::Two && character == '[';
        self.line = match (self.line, character) {
            (LineStart::Blank, ':') => LineStart::Colon,
            (LineStart::Blank, blank) if blank.is_whitespace() => LineStart::Blank,
            _ => LineStart::Other,
        };
        self.hashes = match (self.hashes, character) {
            (Hashes::None, '#') => Hashes::One,
            (Hashes::One | Hashes::Two, '#') => Hashes::Two,
            (Hashes::Two, letter) if letter.is_ascii_alphabetic() => Hashes::Two,
            _ => Hashes::None,
        };
        completes_colons || completes_hashes
    }
}

/// Whether a linguistic comparison ignores the character.
fn is_invisible(character: char) -> bool {
    match character {
        '\t' => false,
        '\u{ad}'
        | '\u{34f}'
        | '\u{61c}'
        | '\u{115f}'
        | '\u{1160}'
        | '\u{17b4}'
        | '\u{17b5}'
        | '\u{180b}'..='\u{180f}' => true,
        '\u{200b}'..='\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2060}'..='\u{206f}' => true,
        '\u{fe00}'..='\u{fe0f}' | '\u{feff}' | '\u{fff9}'..='\u{fffb}' | '\u{e0000}'..='\u{e0fff}' => true,
        other => other.is_control(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn broken(text: &str) -> String {
        let mut search = CommandSearch::default();
        let mut out = String::new();
        for character in text.chars() {
            if search.completes(character) {
                out.push('\\');
            }
            out.push(character);
        }
        out
    }

    #[test]
    fn lines_of_two_colons_are_commands() {
        assert_eq!(broken("::error::a"), ":\\:error::a");
        assert_eq!(broken("a\n \u{a0}\t::b\r::c"), "a\n \u{a0}\t:\\:b\r:\\:c");
        assert_eq!(broken("\u{feff}:\u{200b}:a"), "\u{feff}:\u{200b}\\:a");
        assert_eq!(broken("a::b: : :\n: :"), "a::b: : :\n: :");
    }

    #[test]
    fn hashes_before_a_bracket_are_commands_anywhere() {
        assert_eq!(broken("a ##[error] ###[b]"), "a ##\\[error] ###\\[b]");
        assert_eq!(broken("##vso[task] #\u{200b}#teamcity[x]"), "##vso\\[task] #\u{200b}#teamcity\\[x]");
        assert_eq!(broken("#[a] ## [b] ##é[c]"), "#[a] ## [b] ##é[c]");
    }
}
