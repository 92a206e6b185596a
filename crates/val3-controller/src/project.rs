//! Local project: a folder with a controller's files, and the state of the last pull or push.
//!
//! `.val3/controller.toml` contains the address, the accepted certificate, the identity and the digests of the last pull
//! or push, `.val3/base` the contents for merges. Neither contains a password.

use std::io::Write as _;

use camino::{Utf8Path, Utf8PathBuf};
use serde::{Deserialize, Serialize};
use val3_files::{FileClass, FolderEntryKind, LogFile, Unreadable};

use crate::address::ControllerAddress;
use crate::certificate::CertificateFingerprint;
use crate::connection_settings::ConnectionSettings;
use crate::digest::{FileDigest, FileDigests};
use crate::error::ControllerError;
use crate::identity::ControllerIdentity;
use crate::path::ControllerPath;
use crate::rules::is_ignored;

/// Folder of the remembered data.
const DATA: &str = ".val3";

/// Area of the files at the last pull or push, for merges.
pub(crate) const BASE: &str = "base";

/// Area of downloaded files until all are complete.
pub(crate) const INCOMING: &str = "incoming";

/// File with the address and the digests.
const STATE: &str = ".val3/controller.toml";

/// Version of the state's form.
const VERSION: u32 = 1;

/// Files in [`DATA`] that do not belong in a repository.
const GIT_IGNORE: &str = "backup/\nbase/\nchecked/\nincoming/\n";

/// Comment at the start of the state.
const HEAD: &str =
    "# Written by `val3 pull` and `val3 push`: the controller, and its files at the last pull or push.\n";

/// Controller and files at the last pull or push.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ProjectState {
    version: u32,
    /// Address without a password.
    pub address: String,
    /// Fingerprint of the accepted certificate; only for an address with TLS.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    fingerprint: Option<CertificateFingerprint>,
    /// Whether the controller opens the data connections.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    active: bool,
    /// Folders on the controller that the project contains.
    pub folders: Vec<ControllerPath>,
    /// Serial numbers.
    pub controller: ControllerIdentity,
    /// Files at the last pull or push.
    #[serde(default)]
    pub files: FileDigests,
}

/// A folder with the files of a controller.
#[derive(Debug, Clone)]
pub struct ControllerProject {
    folder: Utf8PathBuf,
    /// State of the last pull or push; `None` before the first pull.
    pub state: Option<ProjectState>,
}

impl ProjectState {
    /// Creates the state before the first pull.
    #[must_use]
    pub fn new(address: String, connection: ConnectionSettings, controller: ControllerIdentity) -> Self {
        let ConnectionSettings { fingerprint, is_active: active } = connection;
        let (folders, files) = (Vec::new(), FileDigests::new());
        Self { version: VERSION, address, fingerprint, active, folders, controller, files }
    }

    /// Connection settings for an address: the last pull's settings if it was from the same server, else the defaults.
    #[must_use]
    pub fn connection(&self, address: &ControllerAddress) -> ConnectionSettings {
        match (ControllerAddress::parse(&self.address), address) {
            (Ok(ControllerAddress::Ftp(last)), ControllerAddress::Ftp(server))
                if last.server.is_same_server(&server.server) =>
            {
                let fingerprint = self.fingerprint.filter(|_| server.is_encrypted);
                ConnectionSettings { fingerprint, is_active: self.active }
            }
            _ => ConnectionSettings::default(),
        }
    }
}

impl ControllerProject {
    /// Finds the project around a folder, which is absolute.
    #[must_use]
    pub fn around(folder: &Utf8Path) -> Option<Utf8PathBuf> {
        val3_files::folder_with(folder, STATE.into())
    }

    /// Opens a project, or a folder that becomes one with the first pull.
    ///
    /// # Errors
    /// If the state cannot be read.
    pub fn open(folder: &Utf8Path) -> Result<Self, ControllerError> {
        let path = folder.join(STATE);
        let state: Option<ProjectState> = match val3_files::read_text(&path, FileClass::Record) {
            Err(Unreadable::Missing) => None,
            Err(reason) => return Err(damaged(&path, &reason)),
            Ok(text) => Some(toml::from_str(&text).map_err(|error| damaged(&path, &toml_fault(&text, &error)))?),
        };
        match &state {
            Some(state) if state.version != VERSION => {
                Err(damaged(&path, &format!("it was written by another version of val3 (form {})", state.version)))
            }
            _ => Ok(Self { folder: folder.to_owned(), state }),
        }
    }

    /// Folder of the project.
    #[must_use]
    pub fn folder(&self) -> &Utf8Path {
        &self.folder
    }

    /// Files at the last pull or push.
    pub(crate) fn base(&self) -> FileDigests {
        self.state.as_ref().map(|state| state.files.clone()).unwrap_or_default()
    }

    /// Writes the state.
    pub(crate) fn save(&self) -> Result<(), ControllerError> {
        let Some(state) = &self.state else { return Ok(()) };
        let path = self.folder.join(STATE);
        let text = toml::to_string(state).map_err(|error| local(&path, &error))?;
        write(&path, format!("{HEAD}{text}").as_bytes())?;
        let ignored = self.folder.join(DATA).join(".gitignore");
        if ignored.exists() { Ok(()) } else { write(&ignored, GIT_IGNORE.as_bytes()) }
    }

    /// Path of a file or folder of the project.
    #[must_use]
    pub fn local(&self, path: &ControllerPath) -> Utf8PathBuf {
        self.folder.join(path.as_str())
    }

    /// Path of a file in one of the project's own folders, for example `base`.
    pub(crate) fn stored(&self, area: &str, path: &ControllerPath) -> Utf8PathBuf {
        self.area(area).join(path.as_str())
    }

    /// One of the project's own folders.
    pub(crate) fn area(&self, name: &str) -> Utf8PathBuf {
        self.folder.join(DATA).join(name)
    }

    /// Whether the file existed at the last pull or push.
    pub(crate) fn had_file(&self, path: &ControllerPath) -> bool {
        self.state.as_ref().is_some_and(|state| state.files.contains_key(path))
    }

    /// Content of a file at the last pull or push; `None` if it is not stored.
    pub(crate) fn base_content(&self, path: &ControllerPath) -> Option<Vec<u8>> {
        let bytes = read(&self.stored(BASE, path)).ok()?;
        let digest = self.state.as_ref()?.files.get(path)?;
        (FileDigest::of(&bytes) == *digest).then_some(bytes)
    }

    /// Returns the local files in these folders, without ignored ones.
    ///
    /// # Errors
    /// If a file cannot be read, or is a link or device.
    pub fn local_files(&self, folders: &[ControllerPath]) -> Result<FileDigests, ControllerError> {
        let mut digests = FileDigests::new();
        for folder in folders.iter().filter(|folder| self.local(folder).is_dir()) {
            self.collect(folder, &mut digests)?;
        }
        Ok(digests)
    }

    fn collect(&self, folder: &ControllerPath, digests: &mut FileDigests) -> Result<(), ControllerError> {
        let at = self.local(folder);
        for entry in val3_files::list_folder(&at).map_err(|reason| local(&at, &reason))? {
            let path = folder.child(&entry.name).map_err(ControllerError::Name)?;
            match entry.kind {
                _ if is_ignored(&path) => {}
                FolderEntryKind::File => {
                    let bytes = read(&self.local(&path))?;
                    digests.insert(path, FileDigest::of(&bytes));
                }
                FolderEntryKind::Folder => self.collect(&path, digests)?,
                FolderEntryKind::Special => {
                    return Err(local(&self.local(&path), &"it is a link or a device, which is not transferred"));
                }
            }
        }
        Ok(())
    }
}

/// Reads a local file.
pub(crate) fn read(path: &Utf8Path) -> Result<Vec<u8>, ControllerError> {
    val3_files::read(path, FileClass::Program).map_err(|reason| local(path, &reason))
}

/// Writes a local file, and creates its folder.
pub(crate) fn write(path: &Utf8Path, bytes: &[u8]) -> Result<(), ControllerError> {
    let folder = path.parent().unwrap_or(Utf8Path::new("."));
    val3_files::create_folders(folder).map_err(|reason| local(folder, &reason))?;
    val3_files::replace(path, bytes).map_err(|reason| local(path, &reason))
}

/// Writes a copy of a file that can be downloaded again, without waiting for the disk: with waiting, a pull of 2,000 files
/// took 60 s instead of 10 s.
pub(crate) fn write_copy(path: &Utf8Path, bytes: &[u8]) -> Result<(), ControllerError> {
    let folder = path.parent().unwrap_or(Utf8Path::new("."));
    val3_files::create_folders(folder).map_err(|reason| local(folder, &reason))?;
    let mut file = LogFile::open(path).map_err(|reason| local(path, &reason))?;
    file.write_all(bytes).map_err(|error| local(path, &error))
}

/// Moves a local file, and creates its new folder.
pub(crate) fn move_file(from: &Utf8Path, to: &Utf8Path) -> Result<(), ControllerError> {
    let folder = to.parent().unwrap_or(Utf8Path::new("."));
    val3_files::create_folders(folder).map_err(|reason| local(folder, &reason))?;
    val3_files::rename_file(from, to).map_err(|reason| local(to, &reason))
}

/// Removes a local file if it exists.
pub(crate) fn remove(path: &Utf8Path) -> Result<(), ControllerError> {
    match path.exists() {
        true => val3_files::remove_file(path).map_err(|reason| local(path, &reason)),
        false => Ok(()),
    }
}

/// Removes a folder with its content.
pub(crate) fn remove_tree(folder: &Utf8Path) -> Result<(), ControllerError> {
    val3_files::remove_tree(folder).map_err(|reason| local(folder, &reason))
}

/// Error of the state.
fn damaged(path: &Utf8Path, reason: &dyn std::fmt::Display) -> ControllerError {
    ControllerError::DamagedState { path: path.to_owned(), reason: reason.to_string() }
}

/// Line and reason of a fault in TOML.
fn toml_fault(text: &str, error: &toml::de::Error) -> String {
    let before = error.span().and_then(|span| text.get(..span.start));
    let line = before.map(|before| format!("line {}: ", before.matches('\n').count() + 1));
    format!("{}{}", line.unwrap_or_default(), error.message())
}

/// Error of a local file.
pub(crate) fn local(path: &Utf8Path, reason: &dyn std::fmt::Display) -> ControllerError {
    ControllerError::Local { path: path.to_owned(), reason: reason.to_string() }
}
