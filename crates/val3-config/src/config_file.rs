//! Parsing of a `val3.toml`.

use camino::{Utf8Path, Utf8PathBuf};

use crate::table_file::{KeyPlaces, TableFile};
use crate::{Config, ConfigError, Patterns};

/// Name of a configuration file.
pub const FILE_NAME: &str = "val3.toml";

/// A configuration with its file.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct ConfigFile {
    /// Path of the file.
    pub path: Utf8PathBuf,
    /// Content of the file.
    pub text: String,
    /// Settings in the file.
    pub config: Config,
    /// Byte ranges of the keys in the text.
    places: KeyPlaces,
}

impl ConfigFile {
    /// Parses `text`, the content of the file `path`.
    ///
    /// # Errors
    /// Reports the first error if the text is no valid TOML, has an unknown key, or has a value that its key does not
    /// accept.
    pub fn parse(path: &Utf8Path, text: &str) -> Result<Self, ConfigError> {
        let TableFile { path, text, content: config, places } = TableFile::parse(path, text)?;
        let file = Self { path, text, config, places };
        match file.config.run.default.fault() {
            Some((key, reason)) => {
                let key = format!("run.default.{key}");
                Err(file.fault(&key, format!("`{key}` {reason}"), String::new()))
            }
            None => Ok(file),
        }
    }

    /// Returns the folder to which paths in the file are relative.
    pub fn folder(&self) -> &Utf8Path {
        self.path.parent().unwrap_or(Utf8Path::new(""))
    }

    /// Returns the line of a key (`rules.V0301`), from 1; `None` if the file does not set it.
    pub fn line(&self, key: &str) -> Option<usize> {
        self.places.line(key, &self.text)
    }

    /// Creates an error in the value of `key` that the parser cannot detect, only the code that uses the setting.
    pub fn fault(&self, key: &str, message: String, help: String) -> ConfigError {
        let range = self.places.range(key);
        ConfigError { path: self.path.clone(), text: self.text.clone(), range, message, help }
    }

    /// Whether the file excludes `path` from the check.
    pub fn excludes(&self, path: &Utf8Path) -> bool {
        self.lists(&self.config.exclude, path)
    }

    /// Whether the file lists the application in `folder` as an application with tests.
    pub fn lists_tests_in(&self, folder: &Utf8Path) -> bool {
        self.lists(&self.config.test.applications, folder)
    }

    fn lists(&self, patterns: &Patterns, path: &Utf8Path) -> bool {
        path.strip_prefix(self.folder()).is_ok_and(|inside| patterns.contains(inside))
    }
}

#[cfg(test)]
mod tests;
