//! Reading the text of a `val3.toml`.

use std::collections::BTreeMap;
use std::ops::Range;

use camino::{Utf8Path, Utf8PathBuf};
use serde::Deserialize;
use toml::de::{DeTable, DeValue, Deserializer};

use crate::error::line_of;
use crate::faults::first_fault;
use crate::schema::schema;
use crate::{Config, ConfigError};

/// The name of a configuration file.
pub const FILE_NAME: &str = "val3.toml";

/// A configuration with the file it stands in.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct ConfigFile {
    /// The file.
    pub path: Utf8PathBuf,
    /// Its text.
    pub text: String,
    /// What it says.
    pub config: Config,
    /// Where each key stands (`rules.V0301`), in bytes of the text.
    places: BTreeMap<String, Range<usize>>,
}

impl ConfigFile {
    /// Reads `text`, which stands in the file `path`.
    ///
    /// # Errors
    /// If it is no TOML, has an unknown key, or a value that its key does not take: the first of these faults.
    pub fn parse(path: &Utf8Path, text: &str) -> Result<Self, ConfigError> {
        let error = |range: Range<usize>, message: String, help: String| ConfigError {
            path: path.to_owned(),
            text: text.to_owned(),
            range,
            message,
            help,
        };
        let of_toml = |fault: toml::de::Error| {
            error(fault.span().unwrap_or_default(), fault.message().trim().to_owned(), String::new())
        };
        let table = DeTable::parse(text)
            .map_err(|fault| error(fault.span().unwrap_or_default(), no_toml(fault.message()), String::new()))?;
        if let Some(fault) = first_fault(table.get_ref(), &schema()) {
            return Err(error(fault.range, fault.message, fault.help));
        }
        let mut places = BTreeMap::new();
        collect_places(table.get_ref(), "", &mut places);
        let config = Config::deserialize(Deserializer::from(table)).map_err(of_toml)?;
        Ok(Self { path: path.to_owned(), text: text.to_owned(), config, places })
    }

    /// The folder that paths in the file count from.
    pub fn folder(&self) -> &Utf8Path {
        self.path.parent().unwrap_or(Utf8Path::new(""))
    }

    /// The line of a key (`rules.V0301`), from 1; `None` where the file does not say it.
    pub fn line(&self, key: &str) -> Option<usize> {
        self.places.get(key).map(|place| line_of(&self.text, place.start))
    }

    /// A fault of the setting `key` that only its reader can see.
    pub fn fault(&self, key: &str, message: String, help: String) -> ConfigError {
        let range = self.places.get(key).cloned().unwrap_or_default();
        ConfigError { path: self.path.clone(), text: self.text.clone(), range, message, help }
    }

    /// Whether the file excludes what lies at `path` from being checked.
    pub fn excludes(&self, path: &Utf8Path) -> bool {
        path.strip_prefix(self.folder()).is_ok_and(|inside| self.config.exclude.contains(inside))
    }
}

fn no_toml(reason: &str) -> String {
    format!("this is not TOML: {}", reason.trim())
}

fn collect_places(table: &DeTable<'_>, path: &str, places: &mut BTreeMap<String, Range<usize>>) {
    for (key, value) in table {
        let name = key.get_ref();
        let path = if path.is_empty() { name.to_string() } else { format!("{path}.{name}") };
        if let DeValue::Table(table) = value.get_ref() {
            collect_places(table, &path, places);
        }
        places.insert(path, key.span());
    }
}

#[cfg(test)]
mod tests;
