//! Script that compares a tag with the version and prints the notes of a release.
#![cfg(unix)]
#![allow(clippy::disallowed_methods, clippy::unwrap_used, reason = "scripts run on real files, and a test may stop")]

use std::fs;
use std::process::Command;

use camino::Utf8Path;

const CHANGES: &str = "# Changes\n\n## Unreleased\n\n- later\n\n## 1.2.3\n\n- now\n- too\n\n## 1.2.2\n\n- before\n";

/// Returns the notes of a tag in a project with the version 1.2.3, or the message of the script.
fn notes(changes: &str, tag: &str) -> Result<String, String> {
    let folder = tempfile::tempdir().unwrap();
    let folder = Utf8Path::from_path(folder.path()).unwrap();
    fs::create_dir(folder.join("tools")).unwrap();
    let script = Utf8Path::new(env!("CARGO_MANIFEST_DIR")).join("../tools/release-notes");
    fs::copy(script, folder.join("tools/release-notes")).unwrap();
    fs::write(folder.join("Cargo.toml"), "[workspace.package]\nversion = \"1.2.3\"\n").unwrap();
    fs::write(folder.join("CHANGELOG.md"), changes).unwrap();
    let output = Command::new("sh").args([folder.join("tools/release-notes").as_str(), tag]).output().unwrap();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap().trim().to_owned();
    if output.status.success() { Ok(text(output.stdout)) } else { Err(text(output.stderr)) }
}

#[test]
fn the_notes_are_the_section_of_the_version() {
    assert_eq!(notes(CHANGES, "v1.2.3").unwrap(), "- now\n- too");
}

#[test]
fn another_tag_is_refused() {
    assert_eq!(notes(CHANGES, "v1.2.2").unwrap_err(), "The tag is v1.2.2, but the version in Cargo.toml is 1.2.3");
    assert!(notes(CHANGES, "1.2.3").is_err());
}

#[test]
fn a_version_without_a_section_is_refused() {
    let unreleased = CHANGES.replace("1.2.3", "1.2.1");
    assert_eq!(notes(&unreleased, "v1.2.3").unwrap_err(), "CHANGELOG.md has no section `## 1.2.3`");
}
