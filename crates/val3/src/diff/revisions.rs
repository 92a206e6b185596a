//! Revisions of git.

use camino::{Utf8Path, Utf8PathBuf};
use val3_analysis::paths::normalise;

use super::Versions;
use super::git::Repository;
use crate::user_error::UserError;

/// Reads one revision and the working tree, or two revisions.
pub(super) fn versions(current: &Utf8Path, revisions: &[String], paths: &[Utf8PathBuf]) -> Result<Versions, UserError> {
    let (revisions, path) = arguments(current, revisions, paths)?;
    let path = normalise(&current.join(path));
    let is_project = path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("pjx"));
    let folder = if is_project { path.parent().unwrap_or(&path) } else { &path };
    let repository = Repository::around(folder)?;
    let tree = |revision: &str| {
        let tree = repository.tree(revision)?.ok_or_else(|| unknown(revision))?;
        repository.files_of(&tree)
    };
    let (trees, new) = match revisions.as_slice() {
        [old, new] => ([tree(old)?, tree(new)?], new.clone()),
        [old] => ([tree(old)?, repository.working_tree()?], "working tree".to_owned()),
        _ => return Err(UserError::new("--git requires a revision")),
    };
    let names = [revisions.first().cloned().unwrap_or_default(), new];
    Ok(Versions { trees, names })
}

/// The revisions and the path. `--git REV PATH` looks like two revisions: a word that is none is the path, if it exists in either version.
fn arguments(
    current: &Utf8Path,
    revisions: &[String],
    paths: &[Utf8PathBuf],
) -> Result<(Vec<String>, Utf8PathBuf), UserError> {
    match (revisions, paths) {
        ([old, word], []) if is_path(current, old, word)? => Ok((vec![old.clone()], Utf8PathBuf::from(word))),
        (_, []) => Ok((revisions.to_vec(), ".".into())),
        (_, [path]) => Ok((revisions.to_vec(), path.clone())),
        (_, paths) => Err(UserError::new(format!("--git takes one folder, and {} are given", paths.len()))
            .with_help("write `val3 diff --git REV [REV] [PATH]`")),
    }
}

/// The word is no revision, and names something in the working tree or in the old revision.
fn is_path(current: &Utf8Path, old: &str, word: &str) -> Result<bool, UserError> {
    let repository = Repository::around(current)?;
    if repository.tree(word)?.is_some() {
        return Ok(false);
    }
    Ok(current.join(word).exists() || repository.has(old, word)?)
}

fn unknown(revision: &str) -> UserError {
    UserError::new(format!("there is no revision `{revision}`"))
        .with_help("name a commit, a branch or a tag, such as `HEAD~1`; `git log --oneline` lists commits")
}
