//! The option `--color`, and the environment variables for colours.

use std::env;
use std::ffi::OsString;

use clap::{ColorChoice, ValueEnum};

/// When to colour.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum Color {
    /// On a terminal; NO_COLOR and FORCE_COLOR take precedence
    Auto,
    /// Always
    Always,
    /// Never
    Never,
}

/// Environment variables that request colours even without a terminal.
const FORCING: [&str; 2] = ["FORCE_COLOR", "CLICOLOR_FORCE"];

impl Color {
    /// Whether the output uses colours.
    pub(crate) fn is_wanted(self, is_terminal: bool) -> bool {
        let variable = |name: &str| env::var_os(name).and_then(|value| value.into_string().ok()).unwrap_or_default();
        self.is_wanted_with(&variable, is_terminal)
    }

    /// As [`is_wanted`](Self::is_wanted), with these values of environment variables; missing variables are empty.
    fn is_wanted_with(self, variable: &dyn Fn(&str) -> String, is_terminal: bool) -> bool {
        let is_forced = FORCING.iter().any(|name| !["", "0", "false"].contains(&variable(name).as_str()));
        match self {
            Self::Always => true,
            Self::Never => false,
            Self::Auto if !variable("NO_COLOR").is_empty() => false,
            Self::Auto => is_forced || is_terminal && variable("TERM") != "dumb",
        }
    }

    /// Colours of the help and of argument errors, which are written before the arguments are parsed.
    pub(crate) fn of_help(arguments: impl IntoIterator<Item = OsString>, is_terminal: bool) -> ColorChoice {
        if Self::requested(arguments).is_wanted(is_terminal) { ColorChoice::Always } else { ColorChoice::Never }
    }

    /// Last `--color` in the arguments.
    fn requested(arguments: impl IntoIterator<Item = OsString>) -> Self {
        let mut arguments = arguments.into_iter().map(|argument| argument.to_string_lossy().into_owned());
        let mut found = Self::Auto;
        while let Some(argument) = arguments.next() {
            let value = match argument.as_str() {
                "--" => break,
                "--color" => arguments.next(),
                other => other.strip_prefix("--color=").map(str::to_owned),
            };
            found = value.and_then(|value| Self::from_str(&value, false).ok()).unwrap_or(found);
        }
        found
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn is_wanted(color: Color, variables: &[(&str, &str)], is_terminal: bool) -> bool {
        let value =
            |name: &str| variables.iter().find(|(known, _)| *known == name).map(|(_, value)| (*value).to_owned());
        color.is_wanted_with(&|name| value(name).unwrap_or_default(), is_terminal)
    }

    #[test]
    fn the_option_precedes_variables_and_these_the_terminal() {
        for is_terminal in [false, true] {
            assert!(is_wanted(Color::Always, &[("NO_COLOR", "1")], is_terminal));
            assert!(!is_wanted(Color::Never, &[("FORCE_COLOR", "1")], is_terminal));
            assert!(is_wanted(Color::Auto, &[("FORCE_COLOR", "1"), ("TERM", "dumb")], is_terminal));
            assert!(is_wanted(Color::Auto, &[("CLICOLOR_FORCE", "1"), ("NO_COLOR", "")], is_terminal));
            assert!(!is_wanted(Color::Auto, &[("FORCE_COLOR", "1"), ("NO_COLOR", "1")], is_terminal));
            assert_eq!(is_wanted(Color::Auto, &[("FORCE_COLOR", "0")], is_terminal), is_terminal);
        }
        assert!(!is_wanted(Color::Auto, &[("TERM", "dumb")], true));
    }

    #[test]
    fn the_last_color_of_the_arguments_counts() {
        let requested = |arguments: &[&str]| Color::requested(arguments.iter().map(OsString::from));
        assert_eq!(requested(&["val3", "--color", "never", "check", "--help"]), Color::Never);
        assert_eq!(requested(&["--color=never", "--color=always"]), Color::Always);
        assert_eq!(requested(&["--color", "sometimes"]), Color::Auto);
        assert_eq!(requested(&["eval", "--", "--color=always"]), Color::Auto);
    }
}
