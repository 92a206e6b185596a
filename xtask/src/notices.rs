//! Third-party notices: the licence texts of third-party code in the binary.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;

use anyhow::{Context, bail};
use camino::{Utf8Path, Utf8PathBuf};
use cargo_metadata::{MetadataCommand, Package};

use crate::project;

/// Beginnings of licence file names, in lower case.
const FILE_NAMES: &[&str] = &["license", "licence", "copying", "notice", "copyright", "unlicense"];

/// The standard text of the Apache licence, which contains no owner.
const APACHE: &str = "LICENSE-APACHE";

/// Page with the notices of the standard library, below the folder of the toolchain.
const STANDARD_LIBRARY: &str = "share/doc/rust/COPYRIGHT-library.html";

const HEAD: &str = "\
Third-party software in val3
============================

val3 contains the software below. Its own licences are in LICENSE-MIT and LICENSE-APACHE. The notices of the Rust standard
library are in THIRD-PARTY-RUST.html.
";

/// Returns the notices of the binary for a target.
///
/// # Errors
/// The packages cannot be listed, or a package has no licence text.
pub fn of_binary(target: &str) -> anyhow::Result<String> {
    let mut notices = Notices::default();
    let mut missing = Vec::new();
    for package in packages(target)? {
        let name = format!("{} {}", package.name, package.version);
        let texts = texts(&package)?;
        if texts.is_empty() {
            missing.push(name.clone());
        }
        texts.into_iter().for_each(|text| notices.add(&name, text));
    }
    if !missing.is_empty() {
        bail!("these packages of the binary have no licence text: {}", missing.join(", "));
    }
    notices.add("Schema of the Debug Adapter Protocol", project::read("crates/val3-dap/schema/License-code.txt")?);
    for page in pages()? {
        let name = format!("Page {}", page.file_stem().unwrap_or_default());
        notices.add(&name, page_notices(&fs::read_to_string(&page)?, &page)?);
    }
    if target.contains("musl") {
        notices.add("musl", project::read("packaging/licences/musl.txt")?);
    }
    Ok(notices.text())
}

/// Returns the page with the notices of Rust's standard library, which every binary contains.
///
/// # Errors
/// The toolchain contains no such page.
pub fn of_standard_library() -> anyhow::Result<Utf8PathBuf> {
    let page = project::sysroot()?.join(STANDARD_LIBRARY);
    if !page.is_file() {
        bail!("the toolchain has no {page}, which packages contain");
    }
    Ok(page)
}

/// Returns the third-party packages that are linked into the binary for a target. Procedural macros and build scripts
/// are not part of it.
fn packages(target: &str) -> anyhow::Result<Vec<Package>> {
    let tree = ["tree", "--locked", "--package", "val3", "--target", target, "--edges", "normal,no-proc-macro"];
    let form = ["--prefix", "none", "--no-dedupe", "--format", "{p}"];
    let output = project::cargo(&[&tree[..], &form].concat()).output().context("cannot start cargo")?;
    if !output.status.success() {
        bail!("cargo tree: {}", String::from_utf8_lossy(&output.stderr).trim());
    }
    let linked = linked(&String::from_utf8(output.stdout)?);
    let options = ["--locked".to_owned()];
    let metadata = MetadataCommand::new().current_dir(project::root()).other_options(options).exec()?;
    let mut packages = metadata.packages;
    packages.retain(|package| {
        package.source.is_some() && linked.contains(&(package.name.to_string(), package.version.to_string()))
    });
    packages.sort_by(|a, b| (&a.name, &a.version).cmp(&(&b.name, &b.version)));
    Ok(packages)
}

/// Returns names and versions in the output of `cargo tree`, for example `salsa v0.28.5`.
fn linked(tree: &str) -> BTreeSet<(String, String)> {
    let words = tree.lines().filter_map(|line| {
        let mut words = line.split_whitespace();
        Some((words.next()?.to_owned(), words.next()?.trim_start_matches('v').to_owned()))
    });
    words.collect()
}

/// Returns the licence texts of a package: its files or, if it has none, the standard text of the Apache licence.
fn texts(package: &Package) -> anyhow::Result<Vec<String>> {
    let folder = package.manifest_path.parent().context("a manifest lies in a folder")?;
    let mut files: Vec<Utf8PathBuf> = Vec::new();
    for entry in folder.read_dir_utf8().with_context(|| format!("cannot list {folder}"))? {
        let path = entry?.into_path();
        let name = path.file_name().unwrap_or_default().to_lowercase();
        if path.is_file() && FILE_NAMES.iter().any(|beginning| name.starts_with(beginning)) {
            files.push(path);
        }
    }
    files.sort();
    if files.is_empty() && package.license.as_ref().is_some_and(|licence| licence.contains("Apache-2.0")) {
        files.push(project::root().join(APACHE));
    }
    files.iter().map(|file| fs::read_to_string(file).with_context(|| format!("cannot read {file}"))).collect()
}

/// Returns the pages that the binary contains.
fn pages() -> anyhow::Result<Vec<Utf8PathBuf>> {
    let folder = project::root().join("editors/view/dist");
    let mut pages = Vec::new();
    for entry in folder.read_dir_utf8().with_context(|| format!("cannot list {folder}"))? {
        let path = entry?.into_path();
        if path.extension() == Some("html") {
            pages.push(path);
        }
    }
    pages.sort();
    Ok(pages)
}

/// Returns the comment at the beginning of a page, which contains the notices of the packages in its script.
fn page_notices(page: &str, path: &Utf8Path) -> anyhow::Result<String> {
    let comment = page.split_once("<!--").and_then(|(_, rest)| rest.split_once("-->"));
    let (comment, _) = comment.with_context(|| format!("{path} has no notices"))?;
    Ok(comment.to_owned())
}

/// Licence texts with the names of the software to which they apply. A text that several packages share is written
/// once.
#[derive(Default)]
struct Notices {
    names: BTreeMap<String, Vec<String>>,
}

impl Notices {
    fn add(&mut self, name: &str, text: String) {
        let text = text.lines().map(str::trim_end).collect::<Vec<_>>().join("\n");
        self.names.entry(text.trim_matches('\n').to_owned()).or_default().push(name.to_owned());
    }

    /// Formats all texts, in the order of first names.
    fn text(&self) -> String {
        let mut sections: Vec<_> = self.names.iter().map(|(text, names)| (names.join(", "), text)).collect();
        sections.sort();
        let rule = "-".repeat(80);
        let section = |(names, text): (String, &String)| format!("\n{rule}\n{names}\n{rule}\n\n{text}\n");
        HEAD.to_owned() + &sections.into_iter().map(section).collect::<String>()
    }
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn every_package_of_the_binary_has_a_text() {
        let target = project::host().unwrap();
        let text = of_binary(&target).unwrap();
        let packages = packages(&target).unwrap();
        assert!(packages.len() > 100, "{}", packages.len());
        for package in packages {
            assert!(text.contains(&format!("{} {}", package.name, package.version)), "{}", package.name);
        }
        for name in ["three", "preact", "Debug Adapter Protocol"] {
            assert!(text.contains(name), "{name}");
        }
        assert!(!text.contains("val3-syntax") && !text.contains("insta "), "only foreign packages of the binary");
        assert!(of_standard_library().is_ok());
    }

    #[test]
    fn the_library_of_a_static_binary_has_its_notice() {
        assert!(of_binary("x86_64-unknown-linux-musl").unwrap().contains("Rich Felker"));
    }

    #[test]
    fn a_text_that_several_have_is_written_once() {
        let mut notices = Notices::default();
        notices.add("b 1.0.0", "MIT\nof b \n".to_owned());
        notices.add("c 1.0.0", "Apache\n".to_owned());
        notices.add("d 2.0.0", "MIT\nof b\n\n".to_owned());
        expect![[r"

            --------------------------------------------------------------------------------
            b 1.0.0, d 2.0.0
            --------------------------------------------------------------------------------

            MIT
            of b

            --------------------------------------------------------------------------------
            c 1.0.0
            --------------------------------------------------------------------------------

            Apache
        "]]
        .assert_eq(notices.text().strip_prefix(HEAD).unwrap());
    }

    #[test]
    fn packages_are_read_from_the_tree() {
        let linked = linked("val3 v0.1.0 (/x)\nsalsa v0.28.5\nsalsa v0.28.5\n");
        let names: Vec<_> = linked.iter().map(|(name, version)| format!("{name}={version}")).collect();
        assert_eq!(names, ["salsa=0.28.5", "val3=0.1.0"]);
    }

    #[test]
    fn a_page_without_notices_is_an_error() {
        let error = page_notices("<!doctype html>", Utf8Path::new("a.html")).unwrap_err();
        assert_eq!(error.to_string(), "a.html has no notices");
    }
}
