//! Sets `VAL3_VERSION`, the version of the command: `0.1.0 (abcdef123 2026-11-26)`, or `0.1.0` without a git
//! repository.

#![allow(clippy::disallowed_methods, reason = "a build script reads its environment")]

use std::path::{Path, PathBuf};
use std::process::Command;

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    let crate_folder = PathBuf::from(env!("CARGO_MANIFEST_DIR"));
    let commit = repository(&crate_folder).and_then(|root| commit(&root));
    let version = env!("CARGO_PKG_VERSION");
    let text = commit.map_or_else(|| version.to_owned(), |commit| format!("{version} ({commit})"));
    println!("cargo::rustc-env=VAL3_VERSION={text}");
}

/// Folder of the workspace, if it is the root of a repository. An archive unpacked inside another repository is not.
fn repository(crate_folder: &Path) -> Option<PathBuf> {
    let workspace = crate_folder.ancestors().nth(2)?.canonicalize().ok()?;
    let top = PathBuf::from(git(&workspace, &["rev-parse", "--show-toplevel"])?).canonicalize().ok()?;
    (top == workspace).then_some(workspace)
}

/// Abbreviated hash and date of the current commit. The script runs again only when it changes.
fn commit(root: &Path) -> Option<String> {
    let branch = git(root, &["symbolic-ref", "--quiet", "HEAD"]);
    for name in ["HEAD", "packed-refs"].into_iter().chain(branch.as_deref()) {
        let path = root.join(git(root, &["rev-parse", "--git-path", name])?);
        // With a missing path, the script would run in every build.
        if path.exists() {
            println!("cargo::rerun-if-changed={}", path.display());
        }
    }
    git(root, &["log", "-1", "--no-show-signature", "--abbrev=9", "--date=format:%Y-%m-%d", "--format=%h %cd"])
}

/// Output of a git command; `None` if it fails or git is not installed.
fn git(folder: &Path, arguments: &[&str]) -> Option<String> {
    let output = Command::new("git").arg("-C").arg(folder).args(arguments).output().ok()?;
    let text = String::from_utf8(output.stdout).ok()?.trim().to_owned();
    (output.status.success() && !text.is_empty()).then_some(text)
}
