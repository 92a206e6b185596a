//! Profiles in the files of a cell (`usr/configs/profiles`).

use std::fmt;

use camino::Utf8Path;
use val3_analysis::system::System;
use val3_files::FileClass;
use val3_syntax::document;
use val3_syntax::xml::{self, XmlElement};

use crate::error::SessionError;

/// Profile of a cell.
///
/// The password is not known, because files contain it obscured.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CellProfile {
    /// Name: the file name without `.cfx`.
    pub name: String,
    /// Rights.
    pub rights: ProfileRights,
}

/// Rights of a profile.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ProfileRights {
    /// Whether the user may read applications and the state of the controller (`readAccess`).
    pub read: bool,
    /// Whether the user may load, start and change applications (`writeAccess`).
    pub write: bool,
    /// Whether the user may write and lock signals (`ioWriteAccess`).
    pub write_io: bool,
}

impl ProfileRights {
    /// All rights.
    pub const ALL: Self = Self { read: true, write: true, write_io: true };
}

/// Reads the profiles of the cell around `disk`, sorted by name; none without the folder.
///
/// # Errors
/// A file exists but cannot be read.
pub(crate) fn read(system: &dyn System, disk: &Utf8Path) -> Result<Vec<CellProfile>, SessionError> {
    let Some(usr) = disk.parent() else { return Ok(Vec::new()) };
    let folder = usr.join("configs").join("profiles");
    if system.kind(&folder).is_none() {
        return Ok(Vec::new());
    }
    let files = system.list(&folder).map_err(|error| unreadable(&folder, &error))?;
    let names = files.iter().filter_map(|file| file.strip_suffix(".cfx"));
    names.map(|name| profile(system, &folder, name)).collect()
}

/// Reads the profile with this name from the folder of all profiles.
fn profile(system: &dyn System, folder: &Utf8Path, name: &str) -> Result<CellProfile, SessionError> {
    let file = folder.join(format!("{name}.cfx"));
    let bytes = system.read(&file, FileClass::Cell).map_err(|error| unreadable(&file, &error))?;
    let text = document::text(bytes).map_err(|fault| unreadable(&file, &fault))?;
    Ok(CellProfile { name: name.to_owned(), rights: rights(&text) })
}

fn unreadable(file: &Utf8Path, reason: &dyn fmt::Display) -> SessionError {
    SessionError::UnreadableFile { file: file.to_owned(), reason: reason.to_string() }
}

/// Rights in a profile's file. A right that the file does not name is denied. Writing implies reading.
fn rights(text: &str) -> ProfileRights {
    let parse = val3_syntax::parse(text);
    let entries: Vec<XmlElement<'_>> = xml::root(parse.view()).into_iter().flat_map(XmlElement::elements).collect();
    let write = is_granted(&entries, "writeAccess");
    let read = write || is_granted(&entries, "readAccess");
    ProfileRights { read, write, write_io: is_granted(&entries, "ioWriteAccess") }
}

/// Whether the entries of a profile's file grant a right. The first entry with the name counts.
fn is_granted(entries: &[XmlElement<'_>], right: &str) -> bool {
    let entry = entries.iter().find(|entry| entry.value("name").as_deref() == Some(right));
    entry.and_then(|entry| entry.value("value")).is_some_and(|value| matches!(value.trim(), "true" | "1"))
}

#[cfg(test)]
mod tests {
    use camino::Utf8PathBuf;
    use val3_analysis::system::Memory;

    use super::*;

    #[test]
    fn rights_are_those_of_the_file() {
        let profile = |rights: &str| format!("<Profile><String name=\"password\" value=\"?\"/>{rights}</Profile>");
        let files = [
            ("operator", profile("<Bool name=\"readAccess\" value=\"true\"/>")),
            (
                "default",
                profile("<Bool name=\"writeAccess\" value=\"true\"/><Bool name=\"ioWriteAccess\" value=\"true\"/>"),
            ),
            ("none", profile("")),
        ];
        let file = |(name, text): &(&str, String)| {
            (Utf8PathBuf::from(format!("/cell/usr/configs/profiles/{name}.cfx")), text.clone().into_bytes())
        };
        let system = Memory::new(files.iter().map(file));
        let profiles = read(&system, Utf8Path::new("/cell/usr/usrapp")).unwrap();
        let named = |name: &str| profiles.iter().find(|profile| profile.name == name).unwrap().rights;
        assert_eq!(named("default"), ProfileRights::ALL);
        assert_eq!(named("operator"), ProfileRights { read: true, write: false, write_io: false });
        assert_eq!(named("none"), ProfileRights { read: false, write: false, write_io: false });
        assert_eq!(read(&system, Utf8Path::new("/other/usrapp")).unwrap(), []);
    }
}
