//! Paths in programs and projects: `Disk://a/b`, `./part`, `../part`, `USB0://x`, `part` (6.6).

use std::fmt;

use camino::Utf8Path;
use smol_str::SmolStr;

use super::FileFault;
use super::reserved::is_reserved;

/// Default root of a path without a root.
pub(super) const DISK: &str = "Disk";

/// Controller path in normal form: a root and names. Upward steps are only at the start, because a medium may have a
/// folder above its start folder.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct ControllerPath {
    root: SmolStr,
    parts: Vec<SmolStr>,
}

impl ControllerPath {
    /// Root of a medium.
    #[must_use]
    pub fn root(name: &str) -> Self {
        Self { root: name.into(), parts: Vec::new() }
    }

    /// Parses a path. A path with `./` or `../` starts at `application`, every other path at a root, by default `Disk`.
    /// `\` separates like `/`.
    ///
    /// # Errors
    /// [`FileFault::BadName`] for a name that no medium of the controller supports, and for reserved names.
    pub fn parse(text: &str, application: &Self) -> Result<Self, FileFault> {
        let text = text.trim().replace('\\', "/");
        let (mut path, rest) = match text.split_once("://") {
            Some((root, rest)) => (Self::root(root.trim()), rest),
            None if starts_at_application(&text) => (application.clone(), text.as_str()),
            None => (Self::root(DISK), text.as_str()),
        };
        rest.split('/').try_for_each(|part| path.push(part))?;
        Ok(path)
    }

    /// Appends one part.
    fn push(&mut self, part: &str) -> Result<(), FileFault> {
        match part {
            "" | "." => {}
            ".." if self.parts.last().is_some_and(|last| last != "..") => {
                self.parts.pop();
            }
            ".." => self.parts.push("..".into()),
            name if is_name(name) && !is_reserved(name) => self.parts.push(name.into()),
            _ => return Err(FileFault::BadName),
        }
        Ok(())
    }

    /// The path with `name` appended.
    ///
    /// # Errors
    /// As [`Self::parse`].
    pub fn join(&self, name: &str) -> Result<Self, FileFault> {
        let mut path = self.clone();
        name.replace('\\', "/").split('/').try_for_each(|part| path.push(part))?;
        Ok(path)
    }

    /// Appends `name`, which is a valid name.
    pub(crate) fn child(&self, name: &str) -> Self {
        let mut path = self.clone();
        path.parts.push(name.into());
        path
    }

    /// Returns the path with its last names spelled as in `spelled`.
    pub(super) fn with_names(&self, spelled: &Utf8Path) -> Self {
        let mut path = self.clone();
        let names = path.parts.iter_mut().rev().take_while(|part| *part != "..");
        names.zip(spelled.components().rev()).for_each(|(name, found)| *name = found.as_str().into());
        path
    }

    /// Name of the medium, in the written spelling.
    #[must_use]
    pub fn medium(&self) -> &str {
        &self.root
    }

    /// The names after the root.
    #[must_use]
    pub fn parts(&self) -> &[SmolStr] {
        &self.parts
    }

    /// Last name; `None` for a root, or if the path ends with an upward step.
    #[must_use]
    pub fn name(&self) -> Option<&str> {
        self.parts.last().map(SmolStr::as_str).filter(|name| *name != "..")
    }

    /// The path without its last part.
    #[must_use]
    pub fn parent(&self) -> Self {
        let kept = self.parts.len().saturating_sub(1);
        Self { root: self.root.clone(), parts: self.parts.iter().take(kept).cloned().collect() }
    }

    /// Whether the last name ends in `.` and `extension`, in any letter case.
    #[must_use]
    pub fn has_extension(&self, extension: &str) -> bool {
        let found = self.name().and_then(|name| name.rsplit_once('.'));
        found.is_some_and(|(stem, found)| !stem.is_empty() && found.eq_ignore_ascii_case(extension))
    }
}

impl fmt::Display for ControllerPath {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}://", self.root)?;
        for (at, part) in self.parts.iter().enumerate() {
            write!(f, "{}{part}", if at == 0 { "" } else { "/" })?;
        }
        Ok(())
    }
}

fn starts_at_application(text: &str) -> bool {
    ["./", "../"].iter().any(|start| text.starts_with(start)) || matches!(text, "." | "..")
}

/// Whether every medium supports the name: the names of FAT, the file system of sticks and floppies.
fn is_name(name: &str) -> bool {
    let odd = |character: char| character.is_control() || r#"<>:"|?*"#.contains(character);
    !name.contains(odd) && name.len() <= 255 && !name.ends_with([' ', '.'])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> String {
        let application = ControllerPath::root(DISK).join("cells/app").unwrap();
        ControllerPath::parse(text, &application).map_or_else(|fault| fault.code().to_string(), |path| path.to_string())
    }

    #[test]
    fn the_examples_of_the_manual() {
        assert_eq!(read("article_1"), "Disk://article_1");
        assert_eq!(read("USB0://articles/article_1"), "USB0://articles/article_1");
        assert_eq!(read("./defaultArticle"), "Disk://cells/app/defaultArticle");
    }

    #[test]
    fn forms_that_real_projects_use() {
        assert_eq!(read("Disk://a/2/../b/b.pjx"), "Disk://a/b/b.pjx");
        assert_eq!(read("Disk://..//templates/x"), "Disk://../templates/x");
        assert_eq!(read("../part"), "Disk://cells/part");
        assert_eq!(read("../../.."), "Disk://..");
        assert_eq!(read("/Libraries/x"), "Disk://Libraries/x");
        assert_eq!(read(r"a\b"), "Disk://a/b");
        assert_eq!(read("Disk://"), "Disk://");
    }

    #[test]
    fn odd_names_are_none() {
        for odd in [
            "a:b",
            "C:/x",
            "a?",
            "tab\there",
            "nul\0",
            "end.",
            "Disk://x/y |",
            "file:///etc*",
            ".git/config",
            "a/VAL3.toml",
        ] {
            assert_eq!(read(odd), "22", "{odd}");
        }
        assert_eq!(read(&"n".repeat(256)), "22");
        assert_eq!(read(&"n".repeat(255)), format!("Disk://{}", "n".repeat(255)));
    }

    #[test]
    fn parents_and_names() {
        let path = ControllerPath::root("USB0").join("a/b.ZIP").unwrap();
        assert!(path.has_extension("zip") && !path.parent().has_extension("zip"));
        assert_eq!((path.name(), path.parent().to_string().as_str()), (Some("b.ZIP"), "USB0://a"));
        assert_eq!(ControllerPath::root("USB0").join("..").unwrap().name(), None);
    }
}
