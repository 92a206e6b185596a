//! Scripts with which the GitHub action and the pre-commit hooks install `val3`.
#![cfg(unix)]
#![allow(clippy::disallowed_methods, clippy::unwrap_used, reason = "scripts run on real files, and a test may stop")]

use std::fs;
use std::io::{Read as _, Write as _};
use std::net::TcpListener;
use std::process::{Command, Output};
use std::thread;

use crate::scratch::{Scratch, TAG, archive, error, text};

/// Starts a server on this machine that sends this response to every request, and returns its address.
fn server(status: &'static str) -> String {
    let listener = TcpListener::bind("127.0.0.1:0").unwrap();
    let address = format!("http://{}", listener.local_addr().unwrap());
    thread::spawn(move || {
        for stream in listener.incoming() {
            let mut stream = stream.unwrap();
            // The request fits into one packet.
            assert!(stream.read(&mut [0; 4096]).unwrap() > 0);
            write!(stream, "HTTP/1.1 {status}\r\nContent-Length: 0\r\nConnection: close\r\n\r\n").unwrap();
        }
    });
    address
}

fn assert_released(scratch: &Scratch, output: &Output) {
    assert!(output.status.success(), "{output:?}");
    let path = text(&output.stdout);
    assert_eq!(path.trim(), scratch.path("installed/bin/val3"));
    assert_eq!(text(&Command::new(path.trim()).arg("x").output().unwrap().stdout), "released x\n");
    assert_eq!(scratch.built(), "");
}

fn assert_built(scratch: &Scratch, output: &Output, reason: &str) {
    assert!(output.status.success(), "{output:?}");
    assert!(scratch.built().contains("crates/val3 --root"), "{}", error(output));
    assert!(error(output).contains(&format!("building val3 from source: {reason}")), "{}", error(output));
}

fn assert_refused(scratch: &Scratch, output: &Output, reason: &str) {
    assert!(!output.status.success());
    assert!(error(output).contains(reason), "{}", error(output));
    assert_eq!(scratch.built(), "");
}

#[test]
fn the_released_source_installs_the_archive() {
    let scratch = Scratch::new();
    let commit = scratch.shell("git -C source rev-parse HEAD");
    // The tag, its commit, a branch at the commit, and the clone itself.
    for revision in [TAG, commit.trim(), "main", ""] {
        assert_released(&scratch, &scratch.install().arg(revision).output().unwrap());
        fs::remove_dir_all(scratch.path("installed")).unwrap();
    }
}

#[test]
fn another_revision_is_built() {
    let scratch = Scratch::new();
    scratch.shell("cd source && echo >>Cargo.toml && git commit --quiet --all --message later");
    let commit = scratch.shell("git -C source rev-parse HEAD");
    for revision in [commit.trim(), "main", "v9.9.9", "nowhere", ""] {
        let output = scratch.install().arg(revision).output().unwrap();
        assert_built(&scratch, &output, "this revision is not the release v1.2.3");
        fs::remove_file(scratch.path("cargo.txt")).unwrap();
    }
}

#[test]
fn a_shallow_clone_finds_its_release() {
    let scratch = Scratch::new();
    let clone = scratch.shallow_clone();
    assert_eq!(scratch.shell("git -C clone tag"), "");
    let hook = || {
        let mut hook = scratch.command(clone.join("tools/pre-commit").as_str());
        // git sets these variables for a hook of the checked repository.
        hook.args(["check", "cell"]).env("GIT_DIR", "/nowhere").env("GIT_INDEX_FILE", "/nowhere/index");
        hook.output().unwrap()
    };
    let output = hook();
    assert_eq!(text(&output.stdout), "released check cell\n", "{}", error(&output));
    assert_eq!(scratch.built(), "");
    // The second run installs nothing.
    fs::remove_dir_all(scratch.path("releases")).unwrap();
    assert_eq!(text(&hook().stdout), "released check cell\n");
}

#[test]
fn a_system_without_an_archive_builds() {
    let scratch = Scratch::new();
    fs::remove_file(scratch.path(&format!("releases/{TAG}/{}.tar.gz", archive()))).unwrap();
    assert_built(&scratch, &scratch.install().arg(TAG).output().unwrap(), "there is no file://");
    let scratch = Scratch::new();
    let output = scratch.install().arg(TAG).env("VAL3_RELEASES", server("404 Not Found")).output().unwrap();
    assert_built(&scratch, &output, "there is no http://");
}

#[test]
fn a_failed_download_is_no_missing_archive() {
    for (releases, reason) in
        [(server("403 Forbidden"), "error: 403"), ("http://127.0.0.1:1".to_owned(), "127.0.0.1 port 1")]
    {
        let scratch = Scratch::new();
        let output = scratch.install().arg(TAG).env("VAL3_RELEASES", &releases).output().unwrap();
        assert_refused(&scratch, &output, reason);
        assert!(
            error(&output).contains(&format!("cannot download {releases}/{TAG}/{}.tar.gz", archive())),
            "{output:?}"
        );
    }
}

#[test]
fn tags_that_cannot_be_read_are_an_error() {
    let scratch = Scratch::new();
    let output = scratch.install().arg("main").env("VAL3_REPOSITORY", "file:///nowhere").output().unwrap();
    assert_refused(&scratch, &output, "cannot read the tags of file:///nowhere. The revision v1.2.3 needs no look-up");
}

#[test]
fn a_damaged_archive_is_refused() {
    let scratch = Scratch::new();
    scratch.shell(&format!("echo more >>releases/{TAG}/{}.tar.gz", archive()));
    let output = scratch.install().arg(TAG).output().unwrap();
    assert_refused(&scratch, &output, "does not match its checksum");
    assert!(!scratch.path("installed").exists());
}

#[test]
fn a_command_that_does_not_start_is_reported() {
    let scratch = Scratch::new();
    scratch.release("echo no such library >&2; exit 127");
    let output = scratch.install().arg(TAG).output().unwrap();
    assert_refused(&scratch, &output, "val3 does not start on this system (");
    assert!(error(&output).contains("no such library"), "{output:?}");
}

#[test]
fn nothing_is_downloaded_from_a_placeholder() {
    let scratch = Scratch::new();
    scratch.program("programs/curl", "echo curl started; exit 1");
    let mut install = scratch.install();
    let output = install.arg(TAG).env_remove("VAL3_RELEASES").env_remove("VAL3_REPOSITORY").output().unwrap();
    assert_built(
        &scratch,
        &output,
        "nothing is downloaded from the placeholder https://git.invalid/owner/val3/releases/download.",
    );
    assert!(!error(&output).contains("curl started"), "{output:?}");
}

#[test]
fn the_origin_of_the_clone_has_the_releases() {
    let addresses = [
        ("http://127.0.0.1:1/owner/val3.git", "http://127.0.0.1:1/owner/val3/releases/download/"),
        ("git@127.0.0.1:owner/val3.git", "https://127.0.0.1/owner/val3/releases/download/"),
        ("ssh://git@127.0.0.1/owner/val3", "https://127.0.0.1/owner/val3/releases/download/"),
    ];
    for (origin, releases) in addresses {
        let scratch = Scratch::new();
        scratch.shell(&format!("git -C source remote add origin {origin}"));
        let mut install = scratch.install();
        let output = install.arg(TAG).env_remove("VAL3_RELEASES").env_remove("VAL3_REPOSITORY").output().unwrap();
        assert_refused(&scratch, &output, &format!("cannot download {releases}"));
    }
}

#[test]
fn a_clone_of_a_folder_is_built() {
    let scratch = Scratch::new();
    scratch.shell("git -C source remote add origin /srv/val3.git");
    let mut install = scratch.install();
    let output = install.arg(TAG).env_remove("VAL3_RELEASES").env_remove("VAL3_REPOSITORY").output().unwrap();
    assert_built(&scratch, &output, "the repository /srv/val3.git has no releases.");
}

#[test]
fn the_summary_of_a_step_has_the_report() {
    let scratch = Scratch::new();
    let added = |report: &str| {
        fs::write(scratch.path("report.txt"), report).unwrap();
        fs::write(scratch.path("summary.md"), "").unwrap();
        let mut command = scratch.command("source/tools/step-summary");
        let status = command.args(["val3 check", "report.txt"]).env("GITHUB_STEP_SUMMARY", "summary.md").status();
        assert!(status.unwrap().success());
        fs::read_to_string(scratch.path("summary.md")).unwrap()
    };
    assert_eq!(added("a.pgx:1:1: error\n"), "### val3 check\n\n````text\na.pgx:1:1: error\n````\n");
    assert_eq!(added(""), "### val3 check\n\nNothing to report.\n");
    assert!(added(&"line\n".repeat(501)).ends_with("line\n````\n\nThe log of the step has all 501 lines.\n"));
}

#[test]
fn the_digest_is_that_of_the_source() {
    let scratch = Scratch::new();
    let digest = || scratch.shell("source/tools/source-digest");
    let before = digest();
    assert_eq!(before.trim().len(), 64);
    scratch.shell("mkdir source/target && touch source/target/built");
    assert_eq!(digest(), before);
    scratch.shell("echo more >>source/Cargo.toml");
    assert_ne!(digest(), before);
}
