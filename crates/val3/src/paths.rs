//! Displayed paths: relative to the requested folder or to the current folder, always with `/`.

use camino::{Utf8Component, Utf8Path, Utf8PathBuf};

use crate::printable::one_line;
use crate::user_error::UserError;

/// Base folders of displayed paths. Only names are compared; links are not resolved.
#[derive(Debug)]
pub(crate) struct Paths {
    asked: Utf8PathBuf,
    current: Utf8PathBuf,
    repository: Utf8PathBuf,
}

impl Paths {
    /// Creates the base folders. `asked` are the requested folders; `current` is the absolute path of the current
    /// folder. The base for several requested folders is their deepest common parent, so that no two files get the same
    /// path.
    pub(crate) fn new(asked: &[Utf8PathBuf], current: &Utf8Path) -> Self {
        let absolute = asked.iter().map(|folder| normal(&current.join(folder)));
        let asked = absolute.reduce(|a, b| common(&a, &b)).unwrap_or_default();
        let current = normal(current);
        Self { repository: current.clone(), asked, current }
    }

    /// Sets the absolute path of the repository's root, which is the current folder by default.
    pub(crate) fn within(mut self, repository: Option<&Utf8Path>) -> Self {
        if let Some(folder) = repository {
            self.repository = normal(folder);
        }
        self
    }

    /// Path relative to the repository's root, by which review services identify files.
    pub(crate) fn in_repository(&self, path: &Utf8Path) -> String {
        relative(&self.repository, &self.absolute(path))
    }

    /// The repository's root, with `/`.
    pub(crate) fn source_root(&self) -> String {
        slashes(&self.repository)
    }

    /// Path relative to the requested folder.
    pub(crate) fn relative(&self, path: &Utf8Path) -> String {
        relative(&self.asked, &self.absolute(path))
    }

    /// Path as displayed in one line: as [`to_open`](Self::to_open), with visible control characters.
    pub(crate) fn shown(&self, path: &Utf8Path) -> String {
        one_line(&self.to_open(path)).into_owned()
    }

    /// Path that opens the file from the current folder: relative, or absolute if that is shorter. An address is
    /// unchanged.
    pub(crate) fn to_open(&self, path: &Utf8Path) -> String {
        if is_address(path) {
            return slashes(path);
        }
        let absolute = self.absolute(path);
        let relative = relative(&self.current, &absolute);
        let absolute = slashes(&absolute);
        if relative.len() <= absolute.len() { relative } else { absolute }
    }

    /// Absolute path without `.` and with as few `..` as possible.
    pub(crate) fn absolute(&self, path: &Utf8Path) -> Utf8PathBuf {
        normal(&self.current.join(path))
    }
}

/// Path without `.` and with as few `..` as possible.
fn normal(path: &Utf8Path) -> Utf8PathBuf {
    let mut normal = Utf8PathBuf::new();
    for component in path.components() {
        match component {
            Utf8Component::CurDir => {}
            Utf8Component::ParentDir if normal.file_name().is_some() => {
                normal.pop();
            }
            other => normal.push(other),
        }
    }
    normal
}

fn common(a: &Utf8Path, b: &Utf8Path) -> Utf8PathBuf {
    let pairs = a.components().zip(b.components());
    pairs.take_while(|(a, b)| a == b).map(|(a, _)| a).collect()
}

/// Path of `path` relative to `base`; unchanged if both have no common folder.
pub(crate) fn relative(base: &Utf8Path, path: &Utf8Path) -> String {
    let common = common(base, path);
    if common.as_str().is_empty() {
        return slashes(path);
    }
    let ups = base.components().count() - common.components().count();
    let up = std::iter::repeat_n("..", ups);
    let down = path.components().skip(common.components().count());
    let parts: Vec<_> = up.chain(down.map(|part| part.as_str())).collect();
    if parts.is_empty() { ".".to_owned() } else { parts.join("/") }
}

fn slashes(path: &Utf8Path) -> String {
    path.as_str().replace(std::path::MAIN_SEPARATOR, "/")
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;

    fn paths(asked: &[&str]) -> Paths {
        let asked: Vec<_> = asked.iter().map(Utf8PathBuf::from).collect();
        Paths::new(&asked, "/home/me/cell".into())
    }

    #[test]
    fn paths_below_one_folder_are_relative_to_it() {
        assert_eq!(paths(&["."]).relative("usrapp/a.pgx".into()), "usrapp/a.pgx");
        assert_eq!(paths(&["usrapp/"]).relative("./usrapp/a.pgx".into()), "a.pgx");
        assert_eq!(paths(&["usrapp/x"]).relative("/home/me/cell/usrapp/y/y.pjx".into()), "../y/y.pjx");
    }

    #[test]
    fn the_root_of_several_folders_is_their_common_parent() {
        let paths = paths(&["usrapp/x", "usrapp/y", "usrapp/x/../z"]);
        assert_eq!(paths.relative("usrapp/x/x.pjx".into()), "x/x.pjx");
    }

    #[test]
    fn services_get_the_path_in_the_repository() {
        let path = Utf8Path::new("/home/me/cell/usrapp/a.pgx");
        assert_eq!(paths(&["usrapp"]).in_repository(path), "usrapp/a.pgx");
        assert_eq!(paths(&["usrapp"]).within(Some("/home/me".into())).in_repository(path), "cell/usrapp/a.pgx");
    }

    #[test]
    fn a_line_break_in_a_path_is_visible() {
        let path = Utf8Path::new("/home/me/cell/a\n::error::\u{1b}.pgx");
        assert_eq!(paths(&[]).shown(path), "a␊::error::␛.pgx");
        assert_eq!(paths(&[]).to_open(path), "a\n::error::\u{1b}.pgx");
    }

    #[test]
    fn people_get_the_shorter_path() {
        let paths = paths(&["/srv/cell"]);
        assert_eq!(paths.shown("usrapp/a.pgx".into()), "usrapp/a.pgx");
        assert_eq!(paths.shown("../other/a.pgx".into()), "../other/a.pgx");
        assert_eq!(paths.shown("/srv/cell/a.pgx".into()), "/srv/cell/a.pgx");
        assert_eq!(paths.shown("ftp://robot/log/user.log".into()), "ftp://robot/log/user.log");
    }
}

/// Path that opens a file from the current folder.
///
/// # Errors
/// The current folder cannot be determined.
pub(crate) fn from_here(path: &Utf8Path) -> Result<Utf8PathBuf, UserError> {
    Ok(Paths::new(&[], &current_folder()?).to_open(path).into())
}

/// Whether the text is the address of a controller instead of a path.
pub(crate) fn is_address(path: &Utf8Path) -> bool {
    path.as_str().contains("://")
}

/// Whether the path has this extension, in any letter case.
pub(crate) fn has_extension(path: &Utf8Path, extension: &str) -> bool {
    path.extension().is_some_and(|found| found.eq_ignore_ascii_case(extension))
}

/// Current folder, absolute.
pub(crate) fn current_folder() -> Result<Utf8PathBuf, UserError> {
    let path = std::env::current_dir()
        .map_err(|error| UserError::new(format!("cannot determine the current folder: {error}")))?;
    Utf8PathBuf::from_path_buf(path)
        .map_err(|path| UserError::new(format!("the current folder `{}` is not UTF-8", path.display())))
}
