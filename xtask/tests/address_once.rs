//! Only `Cargo.toml` contains the address of the repository and the publisher of the extension, because both are
//! placeholders.

#![allow(clippy::unwrap_used, reason = "a test may fail loudly")]

use std::fs;

use camino::{Utf8Path, Utf8PathBuf};

/// The file that declares the addresses, and the manifest that is generated from it.
const SPELLED: &[&str] = &["Cargo.toml", "editors/vscode/package.json"];

/// Folders with build output.
const BUILT: &[&str] = &[".git", "target", "node_modules", "dist", "server"];

/// Returns the owner of the repository, which is a part of both addresses.
fn owner() -> &'static str {
    env!("CARGO_PKG_REPOSITORY").rsplit('/').nth(1).unwrap()
}

fn files(folder: &Utf8Path) -> Vec<Utf8PathBuf> {
    let entries = folder.read_dir_utf8().unwrap().map(|entry| entry.unwrap().into_path());
    let (folders, files): (Vec<_>, Vec<_>) = entries.partition(|path| path.is_dir());
    let written = folders.iter().filter(|folder| !BUILT.contains(&folder.file_name().unwrap()));
    written.flat_map(|folder| self::files(folder)).chain(files).collect()
}

fn spells_owner(file: &Utf8Path) -> bool {
    let bytes = fs::read(file).unwrap();
    bytes.windows(owner().len()).any(|part| part == owner().as_bytes())
}

#[test]
fn both_addresses_have_the_owner() {
    assert!(owner().len() > 3, "{}", owner());
    assert!(env!("CARGO_PKG_HOMEPAGE").contains(owner()));
}

#[test]
fn no_other_file_spells_an_address() {
    let root = xtask::project::root();
    let found = files(&root).into_iter().filter(|file| spells_owner(file));
    let mut found: Vec<_> =
        found.map(|file| file.strip_prefix(&root).unwrap().to_string().replace('\\', "/")).collect();
    found.sort();
    assert_eq!(found, SPELLED);
}
