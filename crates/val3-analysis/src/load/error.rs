//! Why nothing can be loaded.

use std::fmt;

use camino::Utf8PathBuf;
use val3_config::ConfigError;

/// The reasons why a workspace cannot be loaded.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum LoadError {
    /// A path that was asked for cannot be used.
    Path {
        /// The path as it was given.
        path: Utf8PathBuf,
        /// The fault, and the remedy.
        reason: String,
    },
    /// Configuration files are at fault; never empty.
    Configuration(Vec<ConfigError>),
}

impl fmt::Display for LoadError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Path { path, reason } => write!(f, "{path}: {reason}"),
            Self::Configuration(errors) => {
                let texts: Vec<String> = errors.iter().map(ConfigError::to_string).collect();
                f.write_str(&texts.join("\n"))
            }
        }
    }
}

impl std::error::Error for LoadError {}
