//! Roots: the folders that tools may read and write.

use camino::{Utf8Path, Utf8PathBuf};
use val3_analysis::system::{Disk, System as _};

use crate::refusal::Refusal;

/// Folders that tools may read and write, with resolved links. Relative paths start at the first folder.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Roots {
    first: Utf8PathBuf,
    others: Vec<Utf8PathBuf>,
}

impl Roots {
    /// Creates roots of existing folders.
    ///
    /// # Errors
    /// A folder does not exist.
    pub fn new(first: &Utf8Path, others: &[Utf8PathBuf]) -> Result<Self, Refusal> {
        let others = others.iter().map(|folder| existing_folder(folder)).collect::<Result<_, _>>()?;
        Ok(Self { first: existing_folder(first)?, others })
    }

    /// Folder at which relative paths start.
    #[must_use]
    pub fn first(&self) -> &Utf8Path {
        &self.first
    }

    /// Resolves a path of a call, including all links. The last components of the path need not exist.
    ///
    /// # Errors
    ///
    /// The path is outside of all roots, or is not valid on every system.
    pub fn resolve(&self, path: &str) -> Result<Utf8PathBuf, Refusal> {
        if let Some(reason) = fault(path) {
            return Err(Refusal(format!(
                "`{}` {reason}: write a path relative to `{}`",
                path.escape_debug(),
                self.first
            )));
        }
        let target = Disk.target(&self.first.join(path));
        if self.contains(&target) {
            return Ok(target);
        }
        Err(Refusal(format!(
            "`{path}` is outside of `{}`: name a path inside, or let the user start `val3 mcp` with --root",
            self.first
        )))
    }

    /// Whether a path with resolved links is in a root.
    pub(crate) fn contains(&self, target: &Utf8Path) -> bool {
        target.starts_with(&self.first) || self.others.iter().any(|root| target.starts_with(root))
    }

    /// Path in answers: relative to the first root, with `/` as separator.
    pub(crate) fn shown(&self, path: &Utf8Path) -> String {
        let relative = path.strip_prefix(&self.first).unwrap_or(path);
        if relative.as_str().is_empty() { ".".to_owned() } else { relative.as_str().replace('\\', "/") }
    }
}

/// Path of an existing folder with resolved links.
fn existing_folder(folder: &Utf8Path) -> Result<Utf8PathBuf, Refusal> {
    let path = folder.canonicalize_utf8().ok().filter(|path| path.is_dir());
    path.ok_or_else(|| Refusal(format!("`{folder}` is no folder: name an existing one with --root")))
}

/// Reason why a string is no valid path, as the end of a sentence.
fn fault(path: &str) -> Option<&'static str> {
    let mut head = path.chars();
    let is_drive = head.next().is_some_and(|first| first.is_ascii_alphabetic()) && head.next() == Some(':');
    if path.is_empty() {
        Some("is empty")
    } else if path.contains(char::is_control) {
        Some("contains a control character")
    } else if path.contains("://") || path.starts_with("file:") {
        Some("is an address")
    } else if path.contains('\\') || is_drive && !cfg!(windows) {
        Some("is a path of Windows")
    } else if path.starts_with('-') {
        Some("begins with a hyphen")
    } else {
        None
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use crate::testing::Folder;

    #[test]
    fn paths_inside_are_resolved() {
        let folder = Folder::new(&[("cell/app/app.pjx", "")]);
        let roots = folder.roots();
        for path in [".", "cell", "cell/app/../app", "cell/new/later.pgx", roots.first().as_str()] {
            assert!(roots.resolve(path).unwrap().starts_with(roots.first()), "{path}");
        }
        assert_eq!(roots.shown(&roots.resolve("cell/./app").unwrap()), "cell/app");
    }

    #[test]
    fn attacks_are_refused_with_a_remedy() {
        let roots = Folder::new(&[("cell/app.pjx", "")]).roots();
        let attacks = [
            "..",
            "../..",
            "cell/../../x",
            "/etc",
            "/etc/passwd",
            "file:///etc/passwd",
            "file:/etc/passwd",
            "cell\0/x",
            "C:\\Windows",
            "C:/Windows",
            "..\\..\\x",
            "\\\\server\\share",
            "Disk://../x",
            "",
            "-",
            "--config=/etc/x",
            "a\nb",
        ];
        for path in attacks {
            let refusal = roots.resolve(path).unwrap_err().0;
            assert!(refusal.contains(": "), "{path}: {refusal}");
        }
    }

    #[cfg(unix)]
    #[test]
    fn links_do_not_lead_outside() {
        use std::os::unix::fs::symlink;
        let folder = Folder::new(&[("cell/app.pjx", "")]);
        let roots = folder.roots();
        symlink("/etc", roots.first().join("cell/etc")).unwrap();
        symlink("../..", roots.first().join("cell/up")).unwrap();
        symlink("cell", roots.first().join("inside")).unwrap();
        assert!(roots.resolve("cell/etc/passwd").is_err() && roots.resolve("cell/up/x").is_err());
        assert!(roots.resolve("inside/app.pjx").is_ok());
    }

    proptest! {
        #[test]
        fn no_path_leads_outside(parts in prop::collection::vec("(\\.\\.|\\.|cell|[a-z/~:\\\\]{1,4}|/)", 0..6)) {
            let folder = Folder::new(&[("cell/app.pjx", "")]);
            let roots = folder.roots();
            if let Ok(path) = roots.resolve(&parts.join("/")) {
                prop_assert!(path.starts_with(roots.first()), "{}", path);
            }
        }
    }
}
