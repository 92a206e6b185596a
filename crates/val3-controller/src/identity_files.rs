//! Reads the identity of a controller from its settings.

use std::fmt::Display;

use quick_xml::Reader;
use quick_xml::events::attributes::AttrError;
use quick_xml::events::{BytesStart, Event};

use crate::access::ControllerFiles;
use crate::error::ControllerError;
use crate::identity::ControllerIdentity;
use crate::path::ControllerPath;
use crate::scan::Presence;

/// Limit of a settings file in bytes.
const SETTINGS_LIMIT: u64 = 16 << 20;

/// Files with the serial number of the controller: s7 and s8, then s6.
const CONTROLLER_FILES: [&str; 2] = ["usr/configs/controller.cfx", "sys/configs/options.cfx"];

/// File with the serial number of the arm.
const ARM_FILE: &str = "usr/configs/arm.cfx";

/// Reads the serial numbers. Files that do not exist have none.
///
/// # Errors
/// If a file cannot be read, or is not XML.
pub(crate) fn read_identity(files: &mut dyn ControllerFiles) -> Result<ControllerIdentity, ControllerError> {
    let mut identity = ControllerIdentity::default();
    for file in CONTROLLER_FILES {
        if let Some(bytes) = settings(files, file)? {
            identity.serial = attribute_value(file, &bytes, "serialNumber")?;
        }
        if !identity.serial.is_empty() {
            break;
        }
    }
    if let Some(bytes) = settings(files, ARM_FILE)? {
        identity.arm = attribute_value(ARM_FILE, &bytes, "orderNumber")?;
    }
    Ok(identity)
}

/// Reads a file; `None` if it does not exist.
fn settings(files: &mut dyn ControllerFiles, path: &str) -> Result<Option<Vec<u8>>, ControllerError> {
    let path = ControllerPath::parse(path).map_err(ControllerError::Name)?;
    if Presence::default().has(files, &path)? { Ok(Some(files.read(&path, SETTINGS_LIMIT)?)) } else { Ok(None) }
}

/// Value of the element with this `name`; empty without the element.
fn attribute_value(file: &str, bytes: &[u8], name: &str) -> Result<String, ControllerError> {
    let text = String::from_utf8_lossy(bytes);
    let text = text.trim_start_matches('\u{feff}');
    let mut reader = Reader::from_str(text);
    loop {
        match reader.read_event().map_err(|error| malformed(file, &error))? {
            Event::Eof => return Ok(String::new()),
            Event::Start(element) | Event::Empty(element) => {
                let attribute = |key| attribute(&element, key).map_err(|error| malformed(file, &error));
                if attribute("name")?.as_deref() == Some(name) {
                    return Ok(attribute("value")?.unwrap_or_default().trim().to_owned());
                }
            }
            _ => {}
        }
    }
}

/// Returns the value of an attribute as written in the file; `None` without the attribute.
fn attribute(element: &BytesStart<'_>, key: &str) -> Result<Option<String>, AttrError> {
    Ok(element.try_get_attribute(key)?.map(|attribute| attribute.value.into_owned()))
}

/// Error for a settings file that is no XML.
fn malformed(file: &str, reason: &dyn Display) -> ControllerError {
    ControllerError::Malformed { file: file.to_owned(), reason: reason.to_string() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::folder::FolderFiles;

    #[test]
    fn each_generation_has_its_file() {
        let folder = tempfile::tempdir().unwrap();
        let path = camino::Utf8Path::from_path(folder.path()).unwrap();
        let mut files = FolderFiles::open(path).unwrap();
        assert_eq!(read_identity(&mut files).unwrap(), ControllerIdentity::default());
        std::fs::create_dir_all(path.join("sys/configs")).unwrap();
        let options = "<options><String name=\"serialNumber\" value=\"F06-1\"/></options>";
        std::fs::write(path.join("sys/configs/options.cfx"), options).unwrap();
        let identity = read_identity(&mut files).unwrap();
        assert_eq!(identity, ControllerIdentity { serial: "F06-1".to_owned(), arm: String::new() });
        std::fs::create_dir_all(path.join("usr/configs")).unwrap();
        let controller = "\u{feff}<controller><String name=\"serialNumber\" value=\" F10-2 \"/></controller>";
        std::fs::write(path.join("usr/configs/controller.cfx"), controller).unwrap();
        std::fs::write(path.join("usr/configs/arm.cfx"), "<arm><String name='orderNumber' value='A3'/></arm>").unwrap();
        let identity = read_identity(&mut files).unwrap();
        assert_eq!(identity, ControllerIdentity { serial: "F10-2".to_owned(), arm: "A3".to_owned() });
        std::fs::write(path.join("usr/configs/controller.cfx"), "<controller><String name=x").unwrap();
        read_identity(&mut files).unwrap_err();
    }
}
