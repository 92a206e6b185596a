//! Origin of all downloads: npm packages, and the actions of workflows.

#![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "a test may fail loudly")]

use std::fs;

use camino::{Utf8Path, Utf8PathBuf};
use serde_json::Value;

/// Registry from which `npm ci` downloads a package without an address.
const REGISTRY: &str = "https://registry.npmjs.org/";

/// Folders with build output or downloads.
const BUILT: &[&str] = &[".git", "target", "node_modules"];

/// Returns the files below a folder with matching names.
fn files(folder: &Utf8Path, is_named: &dyn Fn(&str) -> bool) -> Vec<Utf8PathBuf> {
    let entries = folder.read_dir_utf8().unwrap().map(|entry| entry.unwrap().into_path());
    let (folders, files): (Vec<_>, Vec<_>) = entries.partition(|path| path.is_dir());
    let written = folders.iter().filter(|folder| !BUILT.contains(&folder.file_name().unwrap()));
    let files = files.into_iter().filter(|file| is_named(file.file_name().unwrap()));
    written.flat_map(|folder| self::files(folder, is_named)).chain(files).collect()
}

/// Returns the packages in a lock file that npm would download from elsewhere, or without a checksum.
fn unknown_packages(lock: &str) -> Vec<String> {
    let lock: Value = serde_json::from_str(lock).unwrap();
    let packages = lock["packages"].as_object().unwrap();
    // The package with the empty name is the owner of the lock file.
    packages
        .iter()
        .filter(|(name, package)| !name.is_empty() && !is_known(package))
        .map(|(name, _)| name.clone())
        .collect()
}

/// Whether the package is downloaded from the registry and has a checksum.
fn is_known(package: &Value) -> bool {
    let is_in_registry = |address: &Value| address.as_str().is_some_and(|address| address.starts_with(REGISTRY));
    let has_checksum = package["integrity"].as_str().is_some_and(|sum| sum.starts_with("sha512-"));
    has_checksum && package.get("resolved").is_none_or(is_in_registry)
}

/// Returns the actions in a workflow whose version the owner can move to another commit.
fn movable_actions(workflow: &str) -> Vec<&str> {
    let used = workflow.lines().filter_map(|line| line.trim().trim_start_matches("- ").strip_prefix("uses: "));
    used.filter(|action| !action.starts_with("./") && !is_pinned(action)).collect()
}

/// Whether the action is `owner/name@` with a commit, and its version in a comment.
fn is_pinned(action: &str) -> bool {
    let Some((commit, version)) = action.split_once('@').and_then(|(_, rest)| rest.split_once(" # v")) else {
        return false;
    };
    let is_commit = commit.len() == 40 && commit.bytes().all(|byte| byte.is_ascii_hexdigit());
    is_commit && version.split('.').count() == 3 && version.split('.').all(|number| number.parse::<u16>().is_ok())
}

/// Returns the container images in a workflow whose version the owner can move to another image.
fn movable_images(workflow: &str) -> Vec<&str> {
    let images = workflow.lines().filter_map(|line| {
        let line = line.trim();
        line.strip_prefix("container: ").or_else(|| line.strip_prefix("image: "))
    });
    images.filter(|image| !image.split_once("@sha256:").is_some_and(|(_, digest)| is_digest(digest))).collect()
}

fn is_digest(digest: &str) -> bool {
    digest.len() == 64 && digest.bytes().all(|byte| byte.is_ascii_hexdigit())
}

#[test]
fn packages_of_npm_come_from_its_registry() {
    let locks = files(&xtask::project::root(), &|name| name == "package-lock.json");
    assert!(locks.len() >= 3, "{locks:?}");
    for lock in locks {
        assert_eq!(unknown_packages(&fs::read_to_string(&lock).unwrap()), Vec::<String>::new(), "{lock}");
    }
}

#[test]
fn actions_are_pinned_by_commit_and_images_by_digest() {
    let workflows = files(&xtask::project::root().join(".github/workflows"), &|name| name.ends_with(".yml"));
    assert!(workflows.len() >= 3, "{workflows:?}");
    for workflow in workflows {
        let text = fs::read_to_string(&workflow).unwrap();
        assert_eq!(movable_actions(&text), Vec::<&str>::new(), "{workflow}");
        assert_eq!(movable_images(&text), Vec::<&str>::new(), "{workflow}");
    }
}

#[test]
fn other_origins_are_found() {
    let lock = r#"{ "packages": {
        "": {},
        "a": { "integrity": "sha512-x" },
        "b": { "integrity": "sha512-x", "resolved": "https://registry.npmjs.org/b.tgz" },
        "c": { "integrity": "sha512-x", "resolved": "https://registry.npmjs.org.example.com/c.tgz" },
        "d": { "integrity": "sha512-x", "resolved": "git+ssh://git@host/d.git" },
        "e": { "resolved": "https://registry.npmjs.org/e.tgz" },
        "f": { "integrity": "sha1-x" }
    } }"#;
    assert_eq!(unknown_packages(lock), ["c", "d", "e", "f"]);
    let commit = "0123456789abcdef0123456789abcdef01234567";
    let workflow = format!(
        "- uses: a/a@{commit} # v1.2.3\n  uses: ./x.yml\n- uses: b/b@v1\n  uses: c/c@{commit}\n- uses: d/d@{commit} # v1\n"
    );
    let images = format!("container: a:1@sha256:{}\n  image: b:1\ncontainer: c@sha256:12\n", "ab".repeat(32));
    assert_eq!(movable_images(&images), ["b:1", "c@sha256:12"]);
    let [c, d] = [format!("c/c@{commit}"), format!("d/d@{commit} # v1")];
    assert_eq!(movable_actions(&workflow), ["b/b@v1", c.as_str(), d.as_str()]);
}
