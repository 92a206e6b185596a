//! Errors of loading.

use std::fmt;

use camino::Utf8PathBuf;
use val3_config::ConfigError;

/// Reason why a workspace cannot be loaded.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum LoadError {
    /// A requested path cannot be used.
    Path {
        /// Path as requested.
        path: Utf8PathBuf,
        /// Fault and remedy.
        reason: String,
    },
    /// A requested folder contains no project.
    NoApplication {
        /// Requested folder.
        folder: Utf8PathBuf,
    },
    /// Configuration files are invalid; never empty.
    Configuration(Vec<ConfigError>),
}

/// Message for a folder without a project, with the remedy.
pub const NO_APPLICATION: &str = "there is no VAL 3 application (`.pjx`) in this folder or below; name an application \
                                  folder, a `.pjx`, or a controller folder";

impl fmt::Display for LoadError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Path { path, reason } => write!(f, "{path}: {reason}"),
            Self::NoApplication { folder } => write!(f, "{folder}: {NO_APPLICATION}"),
            Self::Configuration(errors) => {
                let texts: Vec<String> = errors.iter().map(ConfigError::to_string).collect();
                f.write_str(&texts.join("\n"))
            }
        }
    }
}

impl std::error::Error for LoadError {}
