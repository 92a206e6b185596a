//! Files of the archive.

use anyhow::Context;
use camino::Utf8Path;

use super::archive::PackedFile;
use crate::notices;
use crate::project;

/// Files of the project by their paths in the archive.
const FILES: &[(&str, &str)] = &[
    ("README.md", "packaging/README.md"),
    ("CHANGELOG.md", "CHANGELOG.md"),
    ("LICENSE-MIT", "LICENSE-MIT"),
    ("LICENSE-APACHE", "LICENSE-APACHE"),
];

/// Folders of the project, which have the same path in the archive.
const FOLDERS: &[&str] = &[
    "examples/palletiser",
    "editors/emacs",
    "editors/helix",
    "editors/kakoune",
    "editors/kate",
    "editors/neovim",
    "editors/schema",
    "editors/vim",
];

/// Pages about the editors of [`FOLDERS`].
const EDITORS: &str = "editors";

/// Files of the archive, the command first.
///
/// # Errors
/// If a folder cannot be listed, or the toolchain has no notices of the standard library.
pub(super) fn of_archive(binary: &Utf8Path, notices: &Utf8Path) -> anyhow::Result<Vec<PackedFile>> {
    let command = binary.file_name().context("a binary has a name")?;
    let mut files = vec![PackedFile { path: command.to_owned(), source: binary.to_owned(), is_program: true }];
    files.push(PackedFile::new("THIRD-PARTY.txt", notices));
    files.push(PackedFile::new("THIRD-PARTY-RUST.html", notices::of_standard_library()?));
    files.extend(of_project()?);
    Ok(files)
}

/// Files of the project in the archive.
fn of_project() -> anyhow::Result<Vec<PackedFile>> {
    let root = project::root();
    let mut files: Vec<_> = FILES.iter().map(|(path, source)| PackedFile::new(*path, root.join(source))).collect();
    add_files(&root, EDITORS, false, &mut files)?;
    for folder in FOLDERS {
        add_files(&root, folder, true, &mut files)?;
    }
    Ok(files)
}

/// Adds the files of a folder in the order of their names; those of its folders only if `is_whole`.
fn add_files(root: &Utf8Path, folder: &str, is_whole: bool, files: &mut Vec<PackedFile>) -> anyhow::Result<()> {
    let listed = || format!("cannot list {folder}");
    let mut names = Vec::new();
    for entry in root.join(folder).read_dir_utf8().with_context(listed)? {
        names.push(entry.with_context(listed)?.file_name().to_owned());
    }
    names.sort();
    for name in names {
        let path = format!("{folder}/{name}");
        let source = root.join(&path);
        if source.is_file() {
            files.push(PackedFile::new(path, source));
        } else if is_whole {
            add_files(root, &path, true, files)?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;
    use std::fs;

    use super::*;

    /// Targets of the links in a text of Markdown, without web addresses and without places in a page.
    fn links(text: &str) -> impl Iterator<Item = &str> {
        let targets = text.split("](").skip(1).filter_map(|rest| rest.split([')', '#']).next());
        targets.filter(|target| !target.is_empty() && !target.contains("://"))
    }

    /// A path relative to a folder, without `..`.
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
        let mut targets: BTreeSet<String> = paths.chain(["THIRD-PARTY.txt".into(), "THIRD-PARTY-RUST.html".into()]).collect();
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
        for path in ["README.md", "examples/palletiser/boxes.toml", "editors/neovim.md", "editors/helix/languages.toml"] {
            assert!(paths.iter().any(|known| known == path), "{path}");
        }
        assert!(!paths.iter().any(|path| path.contains("vscode") || path.contains("node_modules")), "{paths:?}");
    }
}
