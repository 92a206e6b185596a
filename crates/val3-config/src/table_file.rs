//! Parser for TOML files whose keys are defined by a type: `val3.toml` and `cell.toml`.

use std::collections::BTreeMap;
use std::ops::Range;

use camino::{Utf8Path, Utf8PathBuf};
use schemars::JsonSchema;
use serde::de::DeserializeOwned;
use toml::Spanned;
use toml::de::{DeTable, DeValue, Deserializer};

use crate::ConfigError;
use crate::error::line_of;
use crate::schema::schema_of;
use crate::validate::{SettingError, first_error};

/// Values of a TOML file, and the byte ranges of its keys.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct TableFile<T> {
    /// Path of the file.
    pub path: Utf8PathBuf,
    /// Text of the file.
    pub text: String,
    /// Values in the file.
    pub content: T,
    pub(crate) places: KeyPlaces,
}

impl<T: JsonSchema + DeserializeOwned> TableFile<T> {
    /// Parses `text`, the content of the file `path`.
    ///
    /// # Errors
    /// Reports the first error if the text is no valid TOML, has an unknown key, or has a value that its key does not
    /// accept.
    pub fn parse(path: &Utf8Path, text: &str) -> Result<Self, ConfigError> {
        let error = |error: SettingError| error.in_file(path, text);
        let no_toml = |cause: toml::de::Error| error(toml_error(&cause, "this is not TOML: "));
        let table = DeTable::parse(text).map_err(no_toml)?;
        if let Some(first) = first_error(table.get_ref(), &schema_of::<T>()) {
            return Err(error(first));
        }
        let places = KeyPlaces::of(table.get_ref());
        let content = T::deserialize(Deserializer::from(table)).map_err(|cause| error(toml_error(&cause, "")))?;
        Ok(Self { path: path.to_owned(), text: text.to_owned(), content, places })
    }
}

impl<T> TableFile<T> {
    /// Returns the folder to which paths in the file are relative.
    pub fn folder(&self) -> &Utf8Path {
        self.path.parent().unwrap_or(Utf8Path::new(""))
    }

    /// Creates an error at `key` (`object[2].in`) that the parser cannot detect, only the code that uses the value. If
    /// the file does not contain the key, the error is at the enclosing table.
    pub fn fault(&self, key: &str, message: String, help: String) -> ConfigError {
        let range = self.places.range(key);
        ConfigError { path: self.path.clone(), text: self.text.clone(), range, message, help }
    }
}

/// Byte ranges of keys in a text, by path: `rules.V0301`, `object[2].in`.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct KeyPlaces(BTreeMap<String, Range<usize>>);

impl KeyPlaces {
    fn of(table: &DeTable<'_>) -> Self {
        let mut places = Self::default();
        places.collect(table, "");
        places
    }

    fn collect(&mut self, table: &DeTable<'_>, path: &str) {
        for (key, value) in table {
            let name = key.get_ref();
            let path = if path.is_empty() { name.to_string() } else { format!("{path}.{name}") };
            self.collect_value(value, &path);
            self.0.insert(path, key.span());
        }
    }

    fn collect_value(&mut self, value: &Spanned<DeValue<'_>>, path: &str) {
        match value.get_ref() {
            DeValue::Table(table) => self.collect(table, path),
            DeValue::Array(entries) => {
                for (index, entry) in entries.iter().enumerate() {
                    let path = format!("{path}[{index}]");
                    self.collect_value(entry, &path);
                    self.0.insert(path, entry.span());
                }
            }
            _ => {}
        }
    }

    /// Returns the range of a key, or of the nearest enclosing table that exists; empty if there is none.
    pub(crate) fn range(&self, key: &str) -> Range<usize> {
        let mut key = key;
        loop {
            match (self.0.get(key), key.rfind(['.', '['])) {
                (Some(range), _) => return range.clone(),
                (None, Some(end)) => key = key.get(..end).unwrap_or_default(),
                (None, None) => return Range::default(),
            }
        }
    }

    /// Returns the line of a key, from 1.
    pub(crate) fn line(&self, key: &str, text: &str) -> Option<usize> {
        self.0.get(key).map(|range| line_of(text, range.start))
    }
}

/// Converts an error of the TOML parser. Its message is prefixed with `before`.
fn toml_error(cause: &toml::de::Error, before: &str) -> SettingError {
    let message = format!("{before}{}", cause.message().trim());
    SettingError { range: cause.span().unwrap_or_default(), message, help: String::new() }
}
