//! Access to git: revisions, their files, and the files of the working tree.

use std::io::{ErrorKind, Seek as _, Write as _};
use std::process::{Command, Output, Stdio};

use camino::{Utf8Path, Utf8PathBuf};
use val3_diff::FileTree;
use val3_files::{FileClass, Unreadable};

use super::wanted::Wanted;
use crate::user_error::UserError;

/// A repository, accessed from a folder in it.
pub(super) struct Repository {
    /// An existing folder in the repository.
    folder: Utf8PathBuf,
    /// Path of the requested folder relative to the repository's root, without a final slash.
    prefix: Utf8PathBuf,
}

impl Repository {
    /// Finds the repository that contains the path, which need not exist in the working tree.
    pub(super) fn around(path: &Utf8Path) -> Result<Self, UserError> {
        let folder = path.ancestors().find(|folder| folder.is_dir()).unwrap_or(Utf8Path::new("."));
        let inner = path.strip_prefix(folder).unwrap_or(Utf8Path::new(""));
        let found = git(folder, &["rev-parse", "--show-prefix"])?;
        if !found.status.success() {
            return Err(no_repository(folder, &found));
        }
        let above = String::from_utf8_lossy(&found.stdout).trim_end_matches(['\n', '\r']).to_owned();
        let prefix = Utf8Path::new(above.trim_end_matches('/')).join(inner);
        Ok(Self { folder: folder.to_owned(), prefix })
    }

    /// Tree of a revision; `None` if there is no such revision.
    pub(super) fn tree(&self, revision: &str) -> Result<Option<String>, UserError> {
        if revision.starts_with('-') {
            return Ok(None);
        }
        let found = git(&self.folder, &["rev-parse", "--verify", "--quiet", &format!("{revision}^{{tree}}")])?;
        Ok(found.status.success().then(|| String::from_utf8_lossy(&found.stdout).trim().to_owned()))
    }

    /// Whether the revision has a file or folder at this path, relative to the current folder.
    pub(super) fn has(&self, revision: &str, path: &str) -> Result<bool, UserError> {
        let found = git(&self.folder, &["rev-parse", "--verify", "--quiet", &format!("{revision}:./{path}")])?;
        Ok(!revision.starts_with('-') && found.status.success())
    }

    /// Newest common ancestor of two revisions; `None` without one.
    pub(super) fn merge_base(&self, old: &str, new: &str) -> Result<Option<String>, UserError> {
        if old.starts_with('-') || new.starts_with('-') {
            return Ok(None);
        }
        let found = git(&self.folder, &["merge-base", old, new])?;
        let base = String::from_utf8_lossy(&found.stdout).trim().to_owned();
        Ok(Some(base).filter(|base| found.status.success() && !base.is_empty()))
    }

    /// Reads the compared files of a tree.
    pub(super) fn files_of(&self, tree: &str) -> Result<FileTree, UserError> {
        let listed = git(&self.folder, &self.restricted(&["ls-tree", "-r", "-z", "--full-tree", tree]))?;
        self.files_in(&successful(listed, "list the files of the revision")?)
    }

    /// Reads the compared staged files.
    pub(super) fn staged(&self) -> Result<FileTree, UserError> {
        let root = self.root()?;
        let listed = git(&root, &self.restricted(&["ls-files", "-z", "--stage"]))?;
        let listed = successful(listed, "list the staged files")?;
        let entries = listed.split(|byte| *byte == 0).filter_map(|entry| std::str::from_utf8(entry).ok());
        if let Some(path) = entries.filter_map(unmerged).next() {
            return Err(UserError::new(format!("`{path}` has conflicts, so no version of it is staged"))
                .with_help("resolve the conflicts and `git add` the file, or compare two revisions"));
        }
        self.files_in(&listed)
    }

    /// Returns the arguments, restricted to the requested folder.
    fn restricted<'a>(&'a self, arguments: &[&'a str]) -> Vec<&'a str> {
        let is_all = self.prefix.as_str().is_empty();
        let folder = ["--", self.prefix.as_str()];
        arguments.iter().copied().chain(folder.into_iter().filter(|_| !is_all)).collect()
    }

    /// Reads the files in a list of entries that end in a zero byte.
    fn files_in(&self, listed: &[u8]) -> Result<FileTree, UserError> {
        let entries = listed.split(|byte| *byte == 0).filter_map(|entry| std::str::from_utf8(entry).ok());
        let blobs: Vec<(&str, &str)> = entries.filter_map(blob).collect();
        let all = Wanted::among(blobs.iter().map(|(path, _)| Utf8Path::new(*path)));
        let wanted = blobs.into_iter().filter_map(|(path, object)| Some((self.wanted(path, &all)?, object)));
        let wanted: Vec<(Utf8PathBuf, &str)> = wanted.collect();
        let bytes = self.contents(wanted.iter().map(|(_, object)| *object))?;
        Ok(FileTree::new(wanted.into_iter().map(|(path, _)| path).zip(bytes)))
    }

    /// Path relative to the requested folder; `None` if the file is not compared.
    fn wanted(&self, path: &str, all: &Wanted) -> Option<Utf8PathBuf> {
        let path = Utf8Path::new(path);
        let inner = path.strip_prefix(&self.prefix).ok()?;
        let inner = if inner.as_str().is_empty() { Utf8Path::new(path.file_name()?) } else { inner };
        // For files in `configs`, the file type depends on the whole path.
        match (FileTree::includes(inner), all.has(path)) {
            (true, _) => Some(inner.to_owned()),
            (false, true) => Some(path.to_owned()),
            (false, false) => None,
        }
    }

    /// Contents of the objects, in order.
    fn contents<'o>(&self, objects: impl Iterator<Item = &'o str>) -> Result<Vec<Vec<u8>>, UserError> {
        let failed = |error: std::io::Error| UserError::new(format!("git cannot list the files: {error}"));
        // The input is a file: git would block on a full output pipe while nothing reads it.
        let mut input = tempfile::tempfile().map_err(failed)?;
        let mut count = 0;
        for object in objects {
            writeln!(input, "{object}").map_err(failed)?;
            count += 1;
        }
        input.rewind().map_err(failed)?;
        let mut command = command(&self.folder, &["cat-file", "--batch"]);
        let output = command.stdin(Stdio::from(input)).output().map_err(not_started)?;
        let output = successful(output, "read files of the revision")?;
        let contents = batch(&output);
        if contents.len() != count {
            return Err(UserError::new("git does not have all files of the revision")
                .with_help("fetch the whole history of this folder, and try again"));
        }
        Ok(contents)
    }

    /// Root of the working tree.
    fn root(&self) -> Result<Utf8PathBuf, UserError> {
        let root = git(&self.folder, &["rev-parse", "--show-toplevel"])?;
        let root = successful(root, "find the working tree; a bare repository has none, so name two revisions")?;
        Ok(Utf8PathBuf::from(String::from_utf8_lossy(&root).trim_end_matches(['\n', '\r'])))
    }

    /// Reads the compared files of the working tree, without files that git ignores.
    pub(super) fn working_tree(&self) -> Result<FileTree, UserError> {
        let root = self.root()?;
        let arguments = self.restricted(&["ls-files", "-z", "--cached", "--others", "--exclude-standard"]);
        let listed = successful(git(&root, &arguments)?, "list the files of the working tree")?;
        let paths = listed.split(|byte| *byte == 0).filter_map(|path| std::str::from_utf8(path).ok());
        let paths: Vec<&str> = paths.filter(|path| !path.is_empty()).collect();
        let all = Wanted::among(paths.iter().map(|path| Utf8Path::new(*path)));
        let mut files = Vec::new();
        for path in paths {
            let Some(inner) = self.wanted(path, &all) else { continue };
            match val3_files::read(&root.join(path), FileClass::Program) {
                Ok(bytes) => files.push((inner, bytes)),
                Err(Unreadable::Missing) => {}
                Err(reason) => return Err(UserError::new(format!("cannot read `{path}`: {reason}"))),
            }
        }
        Ok(FileTree::new(files))
    }
}

/// Path and object in an entry from `git ls-tree`, `100644 blob 1234…<tab>path`, or from `git ls-files --stage`,
/// `100644 1234… 0<tab>path`. `None` for links.
fn blob(entry: &str) -> Option<(&str, &str)> {
    let (head, path) = entry.split_once('\t')?;
    let words: Vec<&str> = head.split(' ').collect();
    let [mode, object] = match words.as_slice() {
        [mode, "blob", object] | [mode, object, "0"] => [mode, object],
        _ => return None,
    };
    mode.starts_with("100").then_some((path, object))
}

/// Path in an entry from `git ls-files --stage` whose stage number is a conflict's (1 to 3), not 0.
fn unmerged(entry: &str) -> Option<&str> {
    let (head, path) = entry.split_once('\t')?;
    head.rsplit(' ').next().is_some_and(|stage| matches!(stage, "1" | "2" | "3")).then_some(path)
}

/// Parses the output of `git cat-file --batch`: `<object> blob <size>`, the bytes, a line end.
fn batch(mut output: &[u8]) -> Vec<Vec<u8>> {
    let mut contents = Vec::new();
    while let Some(end) = output.iter().position(|byte| *byte == b'\n') {
        let head = String::from_utf8_lossy(output.get(..end).unwrap_or(b"")).into_owned();
        let size = head.rsplit(' ').next().and_then(|size| size.parse::<usize>().ok());
        let Some(bytes) = size.and_then(|size| output.get(end + 1..end + 1 + size)) else { break };
        contents.push(bytes.to_vec());
        output = output.get(end + 2 + bytes.len()..).unwrap_or(b"");
    }
    contents
}

fn command(folder: &Utf8Path, arguments: &[&str]) -> Command {
    let mut command = Command::new("git");
    // The repository may be untrusted: its configuration must not start programs, such as a file monitor or a download
    // of missing objects.
    command.env("GIT_NO_LAZY_FETCH", "1").env("GIT_ALLOW_PROTOCOL", "none").args(["-c", "core.fsmonitor=false"]);
    // Special characters in paths have no meaning. Messages are parsed, so they must be in English.
    command
        .env("LC_ALL", "C")
        .arg("--literal-pathspecs")
        .args(["-C", folder.as_str()])
        .args(arguments)
        .stdin(Stdio::null());
    command
}

fn git(folder: &Utf8Path, arguments: &[&str]) -> Result<Output, UserError> {
    command(folder, arguments).output().map_err(not_started)
}

fn no_repository(folder: &Utf8Path, answer: &Output) -> UserError {
    let reason = String::from_utf8_lossy(&answer.stderr).into_owned();
    let error = match reason.contains("not a git repository") {
        true => UserError::new(format!("`{folder}` is not in a git repository")),
        false => UserError::new(format!("git cannot read `{folder}`: {}", reason.trim().trim_start_matches("fatal: "))),
    };
    error.with_help("name a folder of a repository, or compare two folders without --git")
}

fn not_started(error: std::io::Error) -> UserError {
    let reason = if error.kind() == ErrorKind::NotFound {
        "it is not installed, or not in PATH".to_owned()
    } else {
        error.to_string()
    };
    UserError::new(format!("cannot start git: {reason}"))
        .with_help("install git, or compare two folders: `val3 diff OLD NEW`")
}

/// Returns the standard output, or an error if the command has failed.
fn successful(output: Output, purpose: &str) -> Result<Vec<u8>, UserError> {
    if output.status.success() {
        return Ok(output.stdout);
    }
    let message = String::from_utf8_lossy(&output.stderr);
    Err(UserError::new(format!("git cannot {purpose}: {}", message.trim().trim_start_matches("fatal: "))))
}

#[cfg(test)]
mod tests {
    use super::batch;

    #[test]
    fn answers_of_git_are_taken_apart() {
        let found = batch(b"a1 blob 3\nx\ny\nb2 blob 0\n\n");
        assert_eq!(found, [b"x\ny".to_vec(), Vec::new()]);
        assert!(batch(b"a1 missing\n").is_empty());
        assert!(batch(b"a1 blob 9\nx\n").is_empty());
    }
}
