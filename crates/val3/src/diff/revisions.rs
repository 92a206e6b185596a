//! Comparison of git revisions.

use camino::{Utf8Path, Utf8PathBuf};
use val3_analysis::paths::normalise;
use val3_diff::FileTree;

use super::compared_versions::ComparedVersions;
use super::git::Repository;
use crate::args::DiffArgs;
use crate::paths::has_extension;
use crate::user_error::UserError;

/// The revisions and the path to compare.
struct RevisionRequest {
    old: String,
    new: NewVersion,
    path: Utf8PathBuf,
}

/// The new version.
enum NewVersion {
    WorkingTree,
    Staged,
    Revision(String),
}

/// Reads one revision and the working tree or the staged files, or two revisions.
pub(super) fn versions(current: &Utf8Path, args: &DiffArgs) -> Result<ComparedVersions, UserError> {
    let RevisionRequest { old, new, path } = request(current, args)?;
    let path = normalise(&current.join(path));
    let is_project = has_extension(&path, "pjx");
    let folder = if is_project { path.parent().unwrap_or(&path) } else { &path };
    let repository = Repository::around(folder)?;
    let old_tree = revision_files(&repository, &old)?;
    let (new_tree, new) = match new {
        NewVersion::WorkingTree => (repository.working_tree()?, "working tree".to_owned()),
        NewVersion::Staged => (repository.staged()?, "staged files".to_owned()),
        NewVersion::Revision(revision) => (revision_files(&repository, &revision)?, revision),
    };
    Ok(ComparedVersions { trees: [old_tree, new_tree], names: [old, new] })
}

fn revision_files(repository: &Repository, revision: &str) -> Result<FileTree, UserError> {
    let tree = repository.tree(revision)?.ok_or_else(|| unknown(revision))?;
    repository.files_of(&tree)
}

fn request(current: &Utf8Path, args: &DiffArgs) -> Result<RevisionRequest, UserError> {
    if args.staged && args.git.is_empty() {
        let path = match args.paths.as_slice() {
            [] => ".".into(),
            [path] => path.clone(),
            paths => return Err(too_many(paths.len())),
        };
        return Ok(RevisionRequest { old: "HEAD".to_owned(), new: NewVersion::Staged, path });
    }
    let (revisions, path) = arguments(current, &args.git, &args.paths)?;
    let (old, new) = match revisions.as_slice() {
        [old, new] => (old.clone(), Some(new.clone())),
        [word] => match range(current, word)? {
            Some((old, new)) => (old, Some(new)),
            None => (word.clone(), None),
        },
        _ => return Err(UserError::new("--git requires a revision")),
    };
    let new = match (new, args.staged) {
        (Some(_), true) => {
            return Err(UserError::new(
                "--staged compares one revision with the staged files, and two revisions are given",
            )
            .with_help("write `val3 diff --staged`, or `val3 diff --git REV --staged`"));
        }
        (Some(revision), false) => NewVersion::Revision(revision),
        (None, true) => NewVersion::Staged,
        (None, false) => NewVersion::WorkingTree,
    };
    Ok(RevisionRequest { old, new, path })
}

/// Revisions of `OLD..NEW`, or of `OLD...NEW`, which means the changes of NEW since their common ancestor. An omitted
/// side is HEAD. `None` for a single revision, whose name may contain dots.
fn range(current: &Utf8Path, word: &str) -> Result<Option<(String, String)>, UserError> {
    let split =
        word.split_once("...").map(|sides| (sides, true)).or_else(|| word.split_once("..").map(|sides| (sides, false)));
    let Some(((old, new), is_since_ancestor)) = split else { return Ok(None) };
    let side = |side: &str| if side.is_empty() { "HEAD".to_owned() } else { side.to_owned() };
    let (old, new) = (side(old), side(new));
    if !is_since_ancestor {
        return Ok(Some((old, new)));
    }
    let repository = Repository::around(current)?;
    for revision in [&old, &new] {
        repository.tree(revision)?.ok_or_else(|| unknown(revision))?;
    }
    let base = repository.merge_base(&old, &new)?.ok_or_else(|| {
        UserError::new(format!("`{old}` and `{new}` have no common ancestor"))
            .with_help(format!("compare them directly: `{old}..{new}`"))
    })?;
    Ok(Some((base, new)))
}

/// Splits the arguments into revisions and path. In `--git REV PATH`, clap reads two revisions: a word that is no
/// revision is the path if it exists in either version.
fn arguments(
    current: &Utf8Path,
    revisions: &[String],
    paths: &[Utf8PathBuf],
) -> Result<(Vec<String>, Utf8PathBuf), UserError> {
    match (revisions, paths) {
        ([old, word], []) if is_path(current, old, word)? => Ok((vec![old.clone()], Utf8PathBuf::from(word))),
        (_, []) => Ok((revisions.to_vec(), ".".into())),
        (_, [path]) => Ok((revisions.to_vec(), path.clone())),
        (_, paths) => Err(too_many(paths.len())),
    }
}

fn too_many(count: usize) -> UserError {
    UserError::new(format!("git compares one folder, and {count} are given"))
        .with_help("write `val3 diff --git REV [REV] [PATH]` or `val3 diff --staged [PATH]`")
}

/// Whether the word is no revision, and is a path in the working tree or in the old revision.
fn is_path(current: &Utf8Path, old: &str, word: &str) -> Result<bool, UserError> {
    let repository = Repository::around(current)?;
    if repository.tree(word)?.is_some() {
        return Ok(false);
    }
    let old = range(current, old)?.map_or_else(|| old.to_owned(), |(old, _)| old);
    Ok(current.join(word).exists() || repository.has(&old, word)?)
}

fn unknown(revision: &str) -> UserError {
    UserError::new(format!("there is no revision `{revision}`"))
        .with_help("name a commit, a branch or a tag, such as `HEAD~1`; `git log --oneline` lists commits")
}
