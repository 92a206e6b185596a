//! The script that the GitHub action and the pre-commit hook install `val3` with.
#![cfg(unix)]
#![allow(clippy::disallowed_methods, clippy::unwrap_used, reason = "scripts run on real files, and a test may stop")]

use std::fs;
use std::process::{Command, Output};

use camino::{Utf8Path, Utf8PathBuf};
use tempfile::TempDir;

const TAG: &str = "v1.2.3";

/// A folder with a `cargo` that only records its arguments, and with the releases that the script finds.
struct Scratch(TempDir);

impl Scratch {
    fn new() -> Self {
        let scratch = Self(tempfile::tempdir().unwrap());
        scratch.command("programs/cargo", &format!("echo \"$@\" >{}", scratch.path("cargo.txt")));
        scratch
    }

    fn path(&self, path: &str) -> Utf8PathBuf {
        Utf8Path::from_path(self.0.path()).unwrap().join(path)
    }

    /// Makes an executable script. A process of its own writes it: while this process had it open, a thread could not
    /// execute it.
    fn command(&self, path: &str, line: &str) {
        let path = self.path(path);
        let folder = path.parent().unwrap();
        self.shell(&format!("mkdir -p {folder} && printf '#!/bin/sh\\n%s\\n' '{line}' >{path} && chmod +x {path}"));
    }

    /// Makes a release with an archive for this system, and its checksum.
    fn release(&self) {
        let name = format!("val3-1.2.3-{}", system());
        self.command(&format!("{name}/val3"), "echo released");
        let folder = self.path(&format!("releases/{TAG}"));
        fs::create_dir_all(&folder).unwrap();
        self.shell(&format!("tar -czf {folder}/{name}.tar.gz {name}"));
        self.shell(&format!("cd {folder} && (sha256sum *.gz || shasum -a 256 *.gz) >SHA256SUMS"));
    }

    fn shell(&self, line: &str) {
        let status = Command::new("sh").args(["-c", line]).current_dir(self.0.path()).status().unwrap();
        assert!(status.success(), "{line}");
    }

    fn install(&self, tag: &str) -> Output {
        let search = format!("{}:{}", self.path("programs"), std::env::var("PATH").unwrap());
        Command::new(Utf8Path::new(env!("CARGO_MANIFEST_DIR")).join("../tools/install"))
            .args([self.path("installed").as_str(), tag])
            .env("PATH", search)
            .env("VAL3_RELEASES", format!("file://{}", self.path("releases")))
            .output()
            .unwrap()
    }

    fn was_built(&self) -> bool {
        let built = fs::read_to_string(self.path("cargo.txt")).unwrap_or_default();
        assert!(built.is_empty() || built.contains("crates/val3 --root"), "{built}");
        !built.is_empty()
    }
}

/// The system as the names of archives have it.
fn system() -> &'static str {
    match (std::env::consts::OS, std::env::consts::ARCH) {
        ("macos", "aarch64") => "aarch64-apple-darwin",
        ("macos", _) => "x86_64-apple-darwin",
        _ => "x86_64-unknown-linux-gnu",
    }
}

#[test]
fn a_released_archive_is_taken() {
    let scratch = Scratch::new();
    scratch.release();
    let output = scratch.install(TAG);
    assert!(output.status.success(), "{output:?}");
    let path = String::from_utf8(output.stdout).unwrap();
    assert_eq!(path.trim(), scratch.path("installed/bin/val3"));
    assert_eq!(Command::new(path.trim()).output().unwrap().stdout, b"released\n");
    assert!(!scratch.was_built());
}

#[test]
fn a_version_without_an_archive_is_built() {
    for tag in ["v9.9.9", "main", "", "v"] {
        let scratch = Scratch::new();
        scratch.release();
        let output = scratch.install(tag);
        assert!(output.status.success(), "{output:?}");
        assert!(scratch.was_built(), "{tag}");
    }
}

#[test]
fn a_damaged_archive_is_refused() {
    let scratch = Scratch::new();
    scratch.release();
    scratch.shell(&format!("echo more >>releases/{TAG}/val3-1.2.3-{}.tar.gz", system()));
    let output = scratch.install(TAG);
    assert!(!output.status.success());
    assert!(String::from_utf8_lossy(&output.stderr).contains("does not match its checksum"), "{output:?}");
    assert!(!scratch.was_built() && !scratch.path("installed").exists());
}
