//! Files of the archive.

use std::process::Command;

use anyhow::{Context, bail};
use camino::Utf8Path;

use super::archive::PackedFile;
use super::generated;
use crate::notices;
use crate::project;

/// Files of the project, by their paths in the archive.
const FILES: &[(&str, &str)] = &[
    ("README.md", "packaging/README.md"),
    ("CHANGELOG.md", "CHANGELOG.md"),
    ("LICENSE-MIT", "LICENSE-MIT"),
    ("LICENSE-APACHE", "LICENSE-APACHE"),
];

/// Files and folders of the repository with the same path in the archive, as git patterns.
const PATHS: &[&str] = &[
    ":(glob)editors/*.md",
    "editors/emacs",
    "editors/helix",
    "editors/kakoune",
    "editors/kate",
    "editors/neovim",
    "editors/schema",
    "editors/vim",
    "examples/palletiser",
];

/// Returns the files of the archive, the command first.
///
/// # Errors
/// The files cannot be listed, or the toolchain contains no notices of the standard library.
pub(super) fn of_archive(
    binary: &Utf8Path,
    notices: &Utf8Path,
    generated: &Utf8Path,
) -> anyhow::Result<Vec<PackedFile>> {
    let command = binary.file_name().context("a binary has a name")?;
    let mut files = vec![PackedFile { path: command.to_owned(), source: binary.to_owned(), is_program: true }];
    files.push(PackedFile::new("THIRD-PARTY.txt", notices));
    files.push(PackedFile::new("THIRD-PARTY-RUST.html", notices::of_standard_library()?));
    files.extend(of_project()?);
    for folder in generated::FOLDERS {
        files.extend(listed(generated, folder)?);
    }
    Ok(files)
}

/// Returns the files of the project in the archive.
fn of_project() -> anyhow::Result<Vec<PackedFile>> {
    let root = project::root();
    let mut files: Vec<_> = FILES.iter().map(|(path, source)| PackedFile::new(*path, root.join(source))).collect();
    files.extend(tracked()?.into_iter().map(|path| PackedFile::new(path.as_str(), root.join(&path))));
    Ok(files)
}

/// Returns the files that match [`PATHS`] in the repository, without files that runs of the example have written.
fn tracked() -> anyhow::Result<Vec<String>> {
    let mut git = Command::new("git");
    git.args(["ls-files", "-z", "--"]).args(PATHS).current_dir(project::root());
    let output = git.output().context("cannot start git, which lists the files of the archive")?;
    if !output.status.success() {
        bail!("git ls-files: {}", String::from_utf8_lossy(&output.stderr).trim());
    }
    let list = String::from_utf8(output.stdout)?;
    Ok(list.split_terminator('\0').map(str::to_owned).collect())
}

/// Returns the files in a folder of the packed command, sorted by name.
fn listed(generated: &Utf8Path, folder: &str) -> anyhow::Result<Vec<PackedFile>> {
    let listed = || format!("cannot list {generated}/{folder}");
    let mut files = Vec::new();
    for entry in generated.join(folder).read_dir_utf8().with_context(listed)? {
        let entry = entry.with_context(listed)?;
        files.push(PackedFile::new(format!("{folder}/{}", entry.file_name()), entry.path()));
    }
    files.sort_by(|a, b| a.path.cmp(&b.path));
    Ok(files)
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;
    use std::fs;

    use super::*;

    /// Returns the link targets in a Markdown text, without web addresses and anchors.
    fn links(text: &str) -> impl Iterator<Item = &str> {
        let targets = text.split("](").skip(1).filter_map(|rest| rest.split([')', '#']).next());
        targets.filter(|target| !target.is_empty() && !target.contains("://"))
    }

    /// Resolves a path relative to a folder, without `..`.
    fn joined(folder: &str, link: &str) -> String {
        let mut parts: Vec<&str> = folder.split('/').filter(|part| !part.is_empty()).collect();
        for part in link.split('/').filter(|part| !part.is_empty() && *part != ".") {
            if part == ".." {
                parts.pop();
            } else {
                parts.push(part);
            }
        }
        parts.join("/")
    }

    #[test]
    fn every_link_has_a_target_in_the_archive() {
        let files = of_project().unwrap();
        let paths = files.iter().map(|file| file.path.clone());
        let packed = ["THIRD-PARTY.txt", "THIRD-PARTY-RUST.html"].iter().chain(generated::FOLDERS);
        let mut targets: BTreeSet<String> = paths.chain(packed.map(|path| (*path).to_owned())).collect();
        // Folders are targets too.
        for path in targets.clone() {
            targets.extend(path.match_indices('/').map(|(end, _)| path[..end].to_owned()));
        }
        let mut dead = Vec::new();
        for file in files.iter().filter(|file| file.path.ends_with(".md")) {
            let (folder, _) = file.path.rsplit_once('/').unwrap_or_default();
            let text = fs::read_to_string(&file.source).unwrap();
            let lost = links(&text).filter(|link| !targets.contains(&joined(folder, link)));
            dead.extend(lost.map(|link| format!("{}: {link}", file.path)));
        }
        assert!(dead.is_empty(), "{dead:#?}");
    }

    #[test]
    fn the_archive_has_an_example_and_recipes() {
        let paths: Vec<_> = of_project().unwrap().into_iter().map(|file| file.path).collect();
        for path in ["README.md", "examples/palletiser/boxes.toml", "editors/neovim.md", "editors/helix/languages.toml"]
        {
            assert!(paths.iter().any(|known| known == path), "{path}");
        }
        assert!(!paths.iter().any(|path| path.contains("vscode") || path.contains("node_modules")), "{paths:?}");
    }
}
