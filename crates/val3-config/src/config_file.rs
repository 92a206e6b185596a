//! Parsing of a `val3.toml`.

use std::collections::BTreeMap;
use std::ops::Range;

use camino::{Utf8Path, Utf8PathBuf};
use serde::Deserialize;
use toml::de::{DeTable, DeValue, Deserializer};

use crate::error::line_of;
use crate::schema::schema;
use crate::validate::{SettingError, first_error};
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
    /// Byte ranges in the text, by key (`rules.V0301`).
    key_ranges: BTreeMap<String, Range<usize>>,
}

impl ConfigFile {
    /// Parses `text`, the content of the file `path`.
    ///
    /// # Errors
    /// Reports the first error if the text is no valid TOML, has an unknown key, or has a value that its key does not
    /// accept.
    pub fn parse(path: &Utf8Path, text: &str) -> Result<Self, ConfigError> {
        let error = |error: SettingError| error.in_file(path, text);
        let no_toml = |cause: toml::de::Error| error(toml_error(&cause, "this is not TOML: "));
        let table = DeTable::parse(text).map_err(no_toml)?;
        if let Some(first) = first_error(table.get_ref(), &schema()) {
            return Err(error(first));
        }
        let mut key_ranges = BTreeMap::new();
        collect_key_ranges(table.get_ref(), "", &mut key_ranges);
        let config = Config::deserialize(Deserializer::from(table)).map_err(|cause| error(toml_error(&cause, "")))?;
        let file = Self { path: path.to_owned(), text: text.to_owned(), config, key_ranges };
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
        self.key_ranges.get(key).map(|range| line_of(&self.text, range.start))
    }

    /// Creates an error in the value of `key` that only the user of the setting can detect.
    pub fn fault(&self, key: &str, message: String, help: String) -> ConfigError {
        let range = self.key_ranges.get(key).cloned().unwrap_or_default();
        ConfigError { path: self.path.clone(), text: self.text.clone(), range, message, help }
    }

    /// Whether the file excludes `path` from the check.
    pub fn excludes(&self, path: &Utf8Path) -> bool {
        self.lists(&self.config.exclude, path)
    }

    /// Whether the file lists the application in `folder` as one with tests.
    pub fn lists_tests_in(&self, folder: &Utf8Path) -> bool {
        self.lists(&self.config.test.applications, folder)
    }

    fn lists(&self, patterns: &Patterns, path: &Utf8Path) -> bool {
        path.strip_prefix(self.folder()).is_ok_and(|inside| patterns.contains(inside))
    }
}

/// Converts an error of the TOML parser. Its message follows `before`.
fn toml_error(cause: &toml::de::Error, before: &str) -> SettingError {
    let message = format!("{before}{}", cause.message().trim());
    SettingError { range: cause.span().unwrap_or_default(), message, help: String::new() }
}

fn collect_key_ranges(table: &DeTable<'_>, path: &str, ranges: &mut BTreeMap<String, Range<usize>>) {
    for (key, value) in table {
        let name = key.get_ref();
        let path = if path.is_empty() { name.to_string() } else { format!("{path}.{name}") };
        if let DeValue::Table(table) = value.get_ref() {
            collect_key_ranges(table, &path, ranges);
        }
        ranges.insert(path, key.span());
    }
}

#[cfg(test)]
mod tests;
