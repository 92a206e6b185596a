//! Paths of files and folders on a controller.

use std::collections::BTreeSet;
use std::fmt::{self, Display};

use serde::{Deserialize, Serialize};

/// Suffix of a file that is being uploaded.
const TEMPORARY: &str = ".val3tmp";

/// Path of a file or folder on a controller, relative to the root of its address, for example
/// `usr/usrapp/demo/start.pgx`. Each name is checked, so that the path means the same file below any local folder.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(try_from = "String", into = "String")]
pub struct ControllerPath(String);

impl ControllerPath {
    /// Folder of the applications (`Disk://`).
    #[must_use]
    pub fn applications() -> Self {
        Self("usr/usrapp".to_owned())
    }

    /// Root of the address.
    pub(crate) fn root() -> Self {
        Self(String::new())
    }

    /// Parses a path with `/` between its names.
    ///
    /// # Errors
    /// If the path is empty, or a name is not allowed.
    pub fn parse(text: &str) -> Result<Self, NameFault> {
        text.split('/').try_fold(Self::root(), |folder, name| folder.child(name))
    }

    /// Returns the path of an entry in this folder.
    ///
    /// # Errors
    /// If the name is not allowed.
    pub fn child(&self, name: &str) -> Result<Self, NameFault> {
        check_name(name)?;
        Ok(if self.0.is_empty() { Self(name.to_owned()) } else { Self(format!("{}/{name}", self.0)) })
    }

    /// The containing folder; `None` for the root.
    #[must_use]
    pub fn parent(&self) -> Option<Self> {
        if self.0.is_empty() {
            return None;
        }
        Some(self.0.rsplit_once('/').map_or(Self::root(), |(folder, _)| Self(folder.to_owned())))
    }

    /// Name of the file or folder; empty for the root.
    #[must_use]
    pub fn name(&self) -> &str {
        self.0.rsplit_once('/').map_or(&self.0, |(_, name)| name)
    }

    /// Path with `/` between its names.
    #[must_use]
    pub fn as_str(&self) -> &str {
        &self.0
    }

    /// Whether this is `folder`, or below it.
    #[must_use]
    pub fn is_in(&self, folder: &Self) -> bool {
        let rest = self.0.strip_prefix(&folder.0);
        rest.is_some_and(|rest| folder.0.is_empty() || rest.is_empty() || rest.starts_with('/'))
    }

    /// Whether this is one of the folders, or below one.
    pub(crate) fn is_in_any(&self, folders: &[Self]) -> bool {
        folders.iter().any(|folder| self.is_in(folder))
    }

    /// Returns the outermost paths, sorted: each path that is not inside another path.
    pub(crate) fn outermost(paths: impl IntoIterator<Item = Self>) -> Vec<Self> {
        let all: BTreeSet<Self> = paths.into_iter().collect();
        let is_inner = |path: &&Self| all.iter().any(|other| other != *path && path.is_in(other));
        all.iter().filter(|path| !is_inner(path)).cloned().collect()
    }

    /// Path for comparisons in any letter case.
    pub(crate) fn in_lower_case(&self) -> Self {
        Self(self.0.to_lowercase())
    }

    /// Name of the application folder that contains the file or folder. `None` outside of `usr/usrapp`, and for a file
    /// directly in this folder.
    #[must_use]
    pub fn application(&self) -> Option<&str> {
        let inner = self.0.strip_prefix(Self::applications().as_str())?.strip_prefix('/')?;
        inner.split_once('/').map(|(name, _)| name)
    }

    /// Whether the file is a project file.
    #[must_use]
    pub fn is_project(&self) -> bool {
        self.name().len() > 4 && has_suffix(self.name(), ".pjx")
    }

    /// Path under which a file is uploaded before it gets its name.
    pub(crate) fn temporary(&self) -> Self {
        Self(format!("{}{TEMPORARY}", self.0))
    }

    /// Number of names.
    pub(crate) fn depth(&self) -> usize {
        if self.0.is_empty() { 0 } else { self.0.split('/').count() }
    }
}

impl Display for ControllerPath {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(if self.0.is_empty() { "/" } else { &self.0 })
    }
}

impl TryFrom<String> for ControllerPath {
    type Error = NameFault;

    fn try_from(text: String) -> Result<Self, NameFault> {
        Self::parse(&text)
    }
}

impl From<ControllerPath> for String {
    fn from(path: ControllerPath) -> Self {
        path.0
    }
}

/// Whether a name has this suffix in any letter case.
pub(crate) fn has_suffix(name: &str, suffix: &str) -> bool {
    name.to_ascii_lowercase().ends_with(suffix)
}

/// Reason why a name from a controller is not used as a file name.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NameFault {
    /// The name.
    pub name: String,
    /// The reason.
    pub reason: NameFaultKind,
}

/// Kind of a wrong name.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum NameFaultKind {
    /// An empty name.
    Empty,
    /// `.` or `..`.
    Relative,
    /// A character that separates names in paths on some system.
    Separator,
    /// A control character.
    Control,
    /// Bytes that are not UTF-8.
    NotUtf8,
    /// A blank or dot at the end, which Windows removes.
    Trailing,
    /// More than 255 bytes.
    Long,
}

impl Display for NameFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let reason = match self.reason {
            NameFaultKind::Empty => "it is empty",
            NameFaultKind::Relative => "it leads to another folder",
            NameFaultKind::Separator => "`/`, `\\` and `:` are not allowed",
            NameFaultKind::Control => "it has a control character",
            NameFaultKind::NotUtf8 => "it is not UTF-8",
            NameFaultKind::Trailing => "it ends with a blank or a dot",
            NameFaultKind::Long => "it has more than 255 bytes",
        };
        write!(f, "the name {:?} is rejected: {reason}", self.name)
    }
}

impl std::error::Error for NameFault {}

fn check_name(name: &str) -> Result<(), NameFault> {
    let fault = match name {
        "" => Some(NameFaultKind::Empty),
        "." | ".." => Some(NameFaultKind::Relative),
        _ if name.contains(['/', '\\', ':']) => Some(NameFaultKind::Separator),
        _ if name.contains(char::is_control) => Some(NameFaultKind::Control),
        _ if name.contains(char::REPLACEMENT_CHARACTER) => Some(NameFaultKind::NotUtf8),
        _ if name.ends_with(['.', ' ']) => Some(NameFaultKind::Trailing),
        _ if name.len() > 255 => Some(NameFaultKind::Long),
        _ => None,
    };
    fault.map_or(Ok(()), |reason| Err(NameFault { name: name.to_owned(), reason }))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_that_lead_elsewhere_are_rejected() {
        for text in ["", "a//b", "..", "a/../b", "./a", "/a", "a\\b", "c:x", "a\nb", "a\u{fffd}", "a.", "b ", "a/"] {
            ControllerPath::parse(text).unwrap_err();
        }
        let long = "x".repeat(256);
        assert_eq!(ControllerPath::parse(&long).unwrap_err().reason, NameFaultKind::Long);
        let fault = ControllerPath::parse("usr/..").unwrap_err();
        assert_eq!(fault.to_string(), "the name \"..\" is rejected: it leads to another folder");
    }

    #[test]
    fn a_path_is_in_its_folders() {
        let path = ControllerPath::parse("usr/usrapp/demo/demo.PJX").unwrap();
        assert!(
            path.is_in(&ControllerPath::applications()) && path.is_in(&ControllerPath::root()) && path.is_in(&path)
        );
        assert!(!path.is_in(&ControllerPath::parse("usr/usr").unwrap()));
        assert_eq!((path.name(), path.depth(), path.is_project()), ("demo.PJX", 4, true));
        assert_eq!(path.parent().unwrap().as_str(), "usr/usrapp/demo");
        assert_eq!(path.temporary().name(), "demo.PJX.val3tmp");
        assert_eq!(path.application(), Some("demo"));
        for outside in ["usr/usrapp/read.me", "usr/usrapp", "usr/usrapp2/demo/demo.pjx", "usr/configs/arm.cfx"] {
            assert_eq!(ControllerPath::parse(outside).unwrap().application(), None, "{outside}");
        }
    }
}
