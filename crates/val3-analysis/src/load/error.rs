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
    /// A folder that was asked for contains no project.
    NoApplication {
        /// The folder.
        folder: Utf8PathBuf,
    },
    /// Configuration files are at fault; never empty.
    Configuration(Vec<ConfigError>),
}

/// The fault of a folder without a project, and the remedy.
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
