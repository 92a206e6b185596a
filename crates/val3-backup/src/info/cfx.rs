//! Settings in `.cfx` files: `<String name="serialNumber" value="…" />` and elements of other types.

use val3_syntax::document;
use val3_syntax::xml::{self, XmlElement};

use crate::{BackupFiles, UnreadFile};

/// Element of a password, which is never read.
const PASSWORD: &str = "Password";

/// Settings of a file in the order of the file, without passwords.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) struct Settings(Vec<Setting>);

/// A setting.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Setting {
    /// Type, which is the name of the element: `String`, `Bool`, …
    pub(super) kind: String,
    /// Name.
    pub(super) name: String,
    /// Value without blanks around it.
    pub(super) value: String,
}

impl Settings {
    /// Reads the settings directly below the root element.
    pub(super) fn of(text: &str) -> Self {
        let parse = val3_syntax::parse(text);
        let elements = xml::root(parse.view()).into_iter().flat_map(XmlElement::elements);
        let readable = elements.filter(|element| element.name() != PASSWORD);
        Self(readable.filter_map(setting).collect())
    }

    /// Returns all settings.
    pub(super) fn iter(&self) -> impl Iterator<Item = &Setting> {
        self.0.iter()
    }

    /// Returns the value of a setting; `None` if it is missing or empty.
    pub(super) fn value(&self, name: &str) -> Option<&str> {
        let setting = self.0.iter().find(|setting| setting.name == name)?;
        Some(setting.value.as_str()).filter(|value| !value.is_empty())
    }
}

fn setting(element: XmlElement<'_>) -> Option<Setting> {
    let (name, value) = (element.value("name")?, element.value("value")?);
    Some(Setting { kind: element.name().to_owned(), name: name.into_owned(), value: value.trim().to_owned() })
}

/// Reads XML files of a backup, and stores the files that cannot be read.
pub struct TextFiles<'f> {
    files: &'f dyn BackupFiles,
    /// Files that exist but cannot be read.
    pub unread: Vec<UnreadFile>,
}

impl<'f> TextFiles<'f> {
    /// Creates a reader of these files.
    #[must_use]
    pub fn new(files: &'f dyn BackupFiles) -> Self {
        Self { files, unread: Vec::new() }
    }

    /// Returns the text of the XML file at this path, in any letter case; `None` if it does not exist or cannot be read.
    pub fn text(&mut self, path: &str) -> Option<String> {
        let file = self.files.files().iter().find(|file| file.path.eq_ignore_ascii_case(path))?;
        let bytes = self.files.read(&file.path);
        let text = bytes.and_then(|bytes| document::text(bytes).map_err(|fault| fault.to_string()));
        match text {
            Ok(text) => Some(text),
            Err(reason) => {
                self.unread.push(UnreadFile { path: file.path.clone(), reason });
                None
            }
        }
    }

    /// Returns the settings in the file at this path; no settings if it does not exist or cannot be read.
    pub(super) fn settings(&mut self, path: &str) -> Settings {
        self.text(path).map(|text| Settings::of(&text)).unwrap_or_default()
    }

    /// Returns the paths of all files directly in a folder, with their names.
    pub(super) fn in_folder(&self, folder: &str) -> Vec<(&'f str, &'f str)> {
        let files: &'f dyn BackupFiles = self.files;
        let paths = files.files().iter().map(|file| file.path.as_str());
        paths.filter_map(|path| Some((path, name_in(folder, path)?))).collect()
    }
}

/// Returns the name of a file directly in the folder; `None` for other files.
fn name_in<'f>(folder: &str, path: &'f str) -> Option<&'f str> {
    let (parent, name) = path.rsplit_once('/').unwrap_or(("", path));
    parent.eq_ignore_ascii_case(folder).then_some(name)
}

/// Joins paths of a backup; an empty folder is the root.
#[must_use]
pub fn joined(folder: &str, path: &str) -> String {
    if folder.is_empty() { path.to_owned() } else { format!("{folder}/{path}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_files_directly_in_the_folder_have_a_name_in_it() {
        assert_eq!(name_in("usr/configs", "usr/Configs/arm.cfx"), Some("arm.cfx"));
        assert_eq!(name_in("usr/configs", "usr/configs/profiles/default.cfx"), None);
        assert_eq!(name_in("", "arm.cfx"), Some("arm.cfx"));
    }
}
