//! A scratch folder with a repository that contains the scripts and one tag, a release of it, and a `cargo` that only
//! records.

#![allow(clippy::disallowed_methods, clippy::unwrap_used, reason = "scripts run on real files, and a test may stop")]

use std::fs;
use std::process::{Command, Output};

use camino::{Utf8Path, Utf8PathBuf};
use tempfile::TempDir;

/// The only tag of the repository.
pub(crate) const TAG: &str = "v1.2.3";

/// A repository address without releases, as in `Cargo.toml` until the repository has an address.
const CARGO: &str = "[workspace.package]\nversion = \"1.2.3\"\nrepository = \"https://git.invalid/owner/val3\"\n";

/// Prints its arguments, so that a test can determine the executed command.
const RELEASED: &str = "echo released \"$@\"";

/// Records its arguments, and installs a command.
const BUILDER: &str = "echo \"$@\" >>\"$SCRATCH/cargo.txt\"; while [ \"$1\" != --root ]; do shift; done; \
                       mkdir -p \"$2/bin\"; cp \"$SCRATCH/built\" \"$2/bin/val3\"";

pub(crate) struct Scratch(TempDir);

impl Scratch {
    /// Creates a repository at the tag, and a release with an archive for this system.
    pub(crate) fn new() -> Self {
        let scratch = Self(tempfile::tempdir().unwrap());
        scratch.program("programs/cargo", BUILDER);
        scratch.program("built", "echo built \"$@\"");
        scratch.release(RELEASED);
        let root = Utf8Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
        fs::create_dir(scratch.path("source")).unwrap();
        fs::write(scratch.path("source/Cargo.toml"), CARGO).unwrap();
        scratch.shell(&format!("cp -r {root}/tools {root}/.pre-commit-hooks.yaml source"));
        scratch.shell(
            "cd source && git init --quiet --initial-branch main && git config user.name a && git config user.email a@b.c \
             && git add . && git commit --quiet --message first && git tag --annotate v1.2.3 --message v1.2.3",
        );
        scratch
    }

    /// Creates a clone with only the tag's commit, without tag names, like pre-commit.
    pub(crate) fn shallow_clone(&self) -> Utf8PathBuf {
        self.shell(&format!(
            "git init --quiet clone && cd clone && git remote add origin {} && git fetch --quiet origin {TAG} --depth=1 \
             && git checkout --quiet FETCH_HEAD",
            self.address()
        ));
        self.path("clone")
    }

    /// Returns the address of the repository.
    pub(crate) fn address(&self) -> String {
        format!("file://{}", self.path("source"))
    }

    pub(crate) fn path(&self, path: &str) -> Utf8PathBuf {
        Utf8Path::from_path(self.0.path()).unwrap().join(path)
    }

    /// Creates an executable script, in a separate process: while this process had it open for writing, a thread could
    /// not execute it.
    pub(crate) fn program(&self, path: &str, line: &str) {
        let path = self.path(path);
        let folder = path.parent().unwrap();
        self.shell(&format!("mkdir -p {folder} && printf '#!/bin/sh\\n%s\\n' '{line}' >{path} && chmod +x {path}"));
    }

    /// Creates the release with an archive for this system, in which `val3` consists of this line, and its checksum.
    pub(crate) fn release(&self, line: &str) {
        self.release_as(&archive(), line);
    }

    /// Creates the release with the archive `name`.
    pub(crate) fn release_as(&self, name: &str, line: &str) {
        self.program(&format!("{name}/val3"), line);
        self.shell(&format!("mkdir -p releases/{TAG} && tar -czf releases/{TAG}/{name}.tar.gz {name}"));
        self.shell(&format!("cd releases/{TAG} && (sha256sum *.gz || shasum -a 256 *.gz) >SHA256SUMS"));
    }

    /// Runs a line in the scratch folder and returns its output.
    pub(crate) fn shell(&self, line: &str) -> String {
        let output = self.command("sh").args(["-c", line]).output().unwrap();
        assert!(output.status.success(), "{line}: {output:?}");
        text(&output.stdout)
    }

    /// Returns a command for a program in the scratch folder, with the repository, the releases and the `cargo` of this
    /// folder.
    pub(crate) fn command(&self, program: &str) -> Command {
        let mut command = Command::new(program);
        command
            .current_dir(self.0.path())
            .env("PATH", format!("{}:{}", self.path("programs"), std::env::var("PATH").unwrap()))
            .env("SCRATCH", self.path(""))
            .env("GIT_CONFIG_GLOBAL", "/dev/null")
            .env("VAL3_RELEASES", format!("file://{}", self.path("releases")))
            .env_remove("VAL3_REPOSITORY");
        command
    }

    /// Returns a command for the repository's script, which installs into `installed`.
    pub(crate) fn install(&self) -> Command {
        let mut command = self.command("source/tools/install");
        command.arg(self.path("installed")).env("VAL3_REPOSITORY", self.address());
        command
    }

    /// Returns the arguments of the started `cargo`; empty if it was not started.
    pub(crate) fn built(&self) -> String {
        fs::read_to_string(self.path("cargo.txt")).unwrap_or_default()
    }
}

/// Returns the archive name for this system.
pub(crate) fn archive() -> String {
    let system = match (std::env::consts::OS, std::env::consts::ARCH) {
        ("macos", processor) => format!("{processor}-apple-darwin"),
        (_, processor) => format!("{processor}-unknown-linux-musl"),
    };
    format!("val3-{}-{system}", TAG.trim_start_matches('v'))
}

pub(crate) fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

pub(crate) fn error(output: &Output) -> String {
    text(&output.stderr)
}
