//! Code in which steps do not end: applications, libraries and programs that the user does not debug.

use std::fmt;
use std::str::FromStr;

use globset::{GlobBuilder, GlobMatcher};
use val3_vm::{Frame, Space};

/// Pattern for code in which a step into a call does not end. `*` stands for any text, `?` for one character, `[ab]` for
/// one of several characters.
#[derive(Debug, Clone)]
pub struct SkipPattern {
    text: String,
    /// Application or library name.
    application: GlobMatcher,
    /// Program name; `None` for all programs.
    program: Option<GlobMatcher>,
}

impl PartialEq for SkipPattern {
    fn eq(&self, other: &Self) -> bool {
        self.text == other.text
    }
}

impl Eq for SkipPattern {}

/// Reason why a text is no [`SkipPattern`].
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct InvalidSkipPattern(String);

impl fmt::Display for InvalidSkipPattern {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl FromStr for SkipPattern {
    type Err = InvalidSkipPattern;

    /// Parses `library` or `library:program`.
    fn from_str(text: &str) -> Result<Self, InvalidSkipPattern> {
        let (application, program) = match text.trim().split_once(':') {
            Some((application, program)) => (application.trim_end(), Some(program.trim_start())),
            None => (text.trim(), None),
        };
        if application.is_empty() || program.is_some_and(str::is_empty) {
            return Err(InvalidSkipPattern("a name is empty".to_owned()));
        }
        let (application, program) = (matcher(application)?, program.map(matcher).transpose()?);
        Ok(Self { text: text.to_owned(), application, program })
    }
}

/// Compiles the pattern of a name.
fn matcher(pattern: &str) -> Result<GlobMatcher, InvalidSkipPattern> {
    let glob = GlobBuilder::new(pattern).build();
    Ok(glob.map_err(|error| InvalidSkipPattern(error.kind().to_string()))?.compile_matcher())
}

impl SkipPattern {
    /// Whether the stack frame belongs to the code.
    pub(crate) fn contains(&self, space: &Space, frame: &Frame) -> bool {
        let Some(image) = space.instance(frame.instance).map(|instance| &instance.image) else { return false };
        let Some(program) = image.programs.get(usize::from(frame.program)) else { return false };
        self.matches(&image.name, &program.name)
    }

    /// Whether a program in memory matches the pattern.
    pub(crate) fn has_code(&self, space: &Space) -> bool {
        space.loaded().any(|(_, instance)| {
            let image = &instance.image;
            image.programs.iter().any(|program| self.matches(&image.name, &program.name))
        })
    }

    /// Returns the pattern as it was written.
    pub(crate) fn text(&self) -> &str {
        &self.text
    }

    fn matches(&self, application: &str, program: &str) -> bool {
        let is_program = |pattern: &GlobMatcher| pattern.is_match(program);
        self.application.is_match(application) && self.program.as_ref().is_none_or(is_program)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn patterns_match_entire_names() {
        let matches = |pattern: &str, (application, program): (&str, &str)| {
            pattern.parse::<SkipPattern>().unwrap().matches(application, program)
        };
        for (pattern, names) in [
            ("Queue*", ("QueueFuncs", "push")),
            ("*Fun?s", ("QueueFuncs", "push")),
            ("[PQ]ueue", ("Queue", "push")),
            ("* : log*", ("main", "logAll")),
            ("a*b*c:log", ("aXbbYc", "log")),
        ] {
            assert!(matches(pattern, names), "{pattern} {names:?}");
        }
        for (pattern, names) in
            [("Queue", ("QueueFuncs", "push")), ("main:log", ("main", "logAll")), ("Ab", ("ab", "log"))]
        {
            assert!(!matches(pattern, names), "{pattern} {names:?}");
        }
    }

    #[test]
    fn unusable_patterns_are_rejected() {
        for text in ["", " ", ":program", "lib:", "lib["] {
            assert!(text.parse::<SkipPattern>().is_err(), "{text}");
        }
    }
}
