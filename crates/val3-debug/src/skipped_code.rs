//! Code in which steps do not end: applications, libraries and programs that the user does not debug.

use std::str::FromStr;

use val3_vm::{Frame, Space};

/// Pattern for code in which a step into a call does not end. `*` stands for any text, `?` for one character.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SkipPattern {
    /// Application or library name.
    application: String,
    /// Program name; `None` for all programs.
    program: Option<String>,
}

/// Error for an empty [`SkipPattern`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct EmptySkipPattern;

impl FromStr for SkipPattern {
    type Err = EmptySkipPattern;

    /// Parses `library` or `library:program`.
    fn from_str(text: &str) -> Result<Self, EmptySkipPattern> {
        let (application, program) = match text.trim().split_once(':') {
            Some((application, program)) => (application.trim_end(), Some(program.trim_start())),
            None => (text.trim(), None),
        };
        if application.is_empty() || program.is_some_and(str::is_empty) {
            return Err(EmptySkipPattern);
        }
        Ok(Self { application: application.to_owned(), program: program.map(str::to_owned) })
    }
}

impl SkipPattern {
    /// Whether the stack frame belongs to the code.
    pub(crate) fn contains(&self, space: &Space, frame: &Frame) -> bool {
        let Some(image) = space.instance(frame.instance).map(|instance| &instance.image) else { return false };
        let Some(program) = image.programs.get(usize::from(frame.program)) else { return false };
        matches(&self.application, &image.name)
            && self.program.as_deref().is_none_or(|pattern| matches(pattern, &program.name))
    }
}

/// Whether the entire text has the form of the pattern.
fn matches(pattern: &str, text: &str) -> bool {
    let mut rest = text.chars();
    match pattern.chars().next() {
        None => text.is_empty(),
        Some('*') => {
            let after = pattern.get(1..).unwrap_or_default();
            text.char_indices()
                .map(|(at, _)| at)
                .chain([text.len()])
                .any(|at| text.get(at..).is_some_and(|text| matches(after, text)))
        }
        Some(wanted) => {
            rest.next().is_some_and(|found| wanted == '?' || wanted == found)
                && matches(pattern.get(wanted.len_utf8()..).unwrap_or_default(), rest.as_str())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn patterns_match_entire_names() {
        for (pattern, text) in [("Queue*", "QueueFuncs"), ("*", ""), ("*Fun?s", "QueueFuncs"), ("a*b*c", "aXbbYc")] {
            assert!(matches(pattern, text), "{pattern} {text}");
        }
        for (pattern, text) in [("Queue", "QueueFuncs"), ("?", ""), ("a*b", "abc"), ("Ab", "ab")] {
            assert!(!matches(pattern, text), "{pattern} {text}");
        }
    }

    #[test]
    fn patterns_have_two_forms() {
        let pattern = |application: &str, program: Option<&str>| {
            Ok(SkipPattern { application: application.to_owned(), program: program.map(str::to_owned) })
        };
        assert_eq!("lib".parse(), pattern("lib", None));
        assert_eq!("* : log*".parse(), pattern("*", Some("log*")));
        for text in ["", " ", ":program", "lib:"] {
            assert_eq!(text.parse::<SkipPattern>(), Err(EmptySkipPattern), "{text}");
        }
    }
}
