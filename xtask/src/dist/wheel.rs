//! The Python wheel with the command and the module `val3`. maturin writes its metadata from `pyproject.toml`, and the package `wheel` packs
//! it. The binary is the same as in the archive, so that it is not built twice.

use std::fs;

use anyhow::{Context, bail};
use camino::{Utf8Path, Utf8PathBuf};

use crate::build::Build;
use crate::notices;
use crate::packaging_tools::{self, Packages};
use crate::project;

/// Last line of the metadata about the project's own licences.
const OWN_LICENCE: &str = "License-File: LICENSE-APACHE\n";

/// Licence files of third-party software: the notices of packages and of the standard library.
const NOTICES: [&str; 2] = ["THIRD-PARTY.txt", "THIRD-PARTY-RUST.html"];

/// Time of the files in a wheel, in seconds since 1970: the earliest time in a zip archive.
const TIME: &str = "315532800";

/// Writes the wheel of `binary` into `folder` and returns its path. `scratch` contains the third-party notices, and
/// receives parts of the wheel.
///
/// A tool is missing or fails, or a file cannot be written.
pub(super) fn write(
    build: &Build,
    binary: &Utf8Path,
    scratch: &Utf8Path,
    folder: &Utf8Path,
) -> anyhow::Result<Utf8PathBuf> {
    let version = env!("CARGO_PKG_VERSION");
    let parts = scratch.join("wheel");
    let scripts = parts.join(format!("val3-{version}.data/scripts"));
    fs::create_dir_all(&scripts).with_context(|| format!("cannot make {scripts}"))?;
    let script = scripts.join(build.command());
    fs::copy(binary, &script).with_context(|| format!("cannot copy {binary} to {script}"))?;
    copy_module(&parts)?;
    describe(build, &scratch.join("THIRD-PARTY.txt"), &parts)?;
    let mut pack = packaging_tools::command(Packages::Wheel, "wheel")?;
    pack.args(["pack", parts.as_str(), "--dest-dir", folder.as_str()]).env("SOURCE_DATE_EPOCH", TIME);
    project::succeed(pack.stdout(std::io::stderr()))?;
    Ok(folder.join(format!("val3-{version}-py3-none-{}.whl", platforms(build)?.join("."))))
}

/// Copies the Python module.
fn copy_module(parts: &Utf8Path) -> anyhow::Result<()> {
    let (source, target) = (project::root().join("python/val3"), parts.join("val3"));
    fs::create_dir_all(&target).with_context(|| format!("cannot make {target}"))?;
    for entry in source.read_dir_utf8().with_context(|| format!("cannot list {source}"))? {
        let file = entry?.into_path();
        let is_part = matches!(file.extension(), Some("py" | "typed"));
        if let (true, Some(name)) = (is_part, file.file_name()) {
            fs::copy(&file, target.join(name)).with_context(|| format!("cannot copy {file} to {target}"))?;
        }
    }
    Ok(())
}

/// Writes the metadata of the project, the platforms, and the licences.
fn describe(build: &Build, packages: &Utf8Path, parts: &Utf8Path) -> anyhow::Result<()> {
    let mut describe = packaging_tools::command(Packages::Wheel, "maturin")?;
    describe.args(["pep517", "write-dist-info", "--metadata-directory", parts.as_str()]);
    project::succeed(describe.stdout(std::io::stderr()))?;
    let info = parts.join(format!("val3-{}.dist-info", env!("CARGO_PKG_VERSION")));
    let standard_library = notices::of_standard_library()?;
    for (name, source) in NOTICES.iter().zip([packages, standard_library.as_path()]) {
        let target = info.join("licenses").join(name);
        fs::copy(source, &target).with_context(|| format!("cannot write {target}"))?;
    }
    let metadata = info.join("METADATA");
    let text = fs::read_to_string(&metadata).with_context(|| format!("cannot read {metadata}"))?;
    fs::write(&metadata, with_notices(&text)?).with_context(|| format!("cannot write {metadata}"))?;
    let tags: String = platforms(build)?.iter().map(|platform| format!("Tag: py3-none-{platform}\n")).collect();
    let wheel = info.join("WHEEL");
    fs::write(&wheel, format!("Wheel-Version: 1.0\nGenerator: val3\nRoot-Is-Purelib: false\n{tags}"))
        .with_context(|| format!("cannot write {wheel}"))
}

/// Adds the third-party notices to the metadata as further licence files.
fn with_notices(metadata: &str) -> anyhow::Result<String> {
    let (before, after) = metadata.split_once(OWN_LICENCE).context("the metadata of the wheel names no licence")?;
    let added: String = NOTICES.iter().map(|name| format!("License-File: {name}\n")).collect();
    Ok(format!("{before}{OWN_LICENCE}{added}{after}"))
}

/// Returns Python's names of the platforms on which the binary runs. A static binary runs with every C library.
fn platforms(build: &Build) -> anyhow::Result<Vec<String>> {
    let target = build.target.as_str();
    let (processor, _) = target.split_once('-').context("a target names its processor")?;
    Ok(match target {
        "aarch64-apple-darwin" => vec!["macosx_11_0_arm64".to_owned()],
        "x86_64-apple-darwin" => vec!["macosx_10_12_x86_64".to_owned()],
        "x86_64-pc-windows-msvc" => vec!["win_amd64".to_owned()],
        "aarch64-pc-windows-msvc" => vec!["win_arm64".to_owned()],
        _ if target.ends_with("-linux-musl") => {
            ["manylinux_2_17", "musllinux_1_1"].map(|library| format!("{library}_{processor}")).into()
        }
        _ if target.ends_with("-linux-gnu") => match &build.glibc {
            Some(version) => vec![format!("manylinux_{}_{processor}", version.replace('.', "_"))],
            // No registry accepts this name, because it is unknown which systems have the same libraries as this one.
            None => vec![format!("linux_{processor}")],
        },
        _ => bail!("Python has no name for {target}"),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::build::Arguments;

    fn of(target: &str, glibc: Option<&str>) -> String {
        let glibc = glibc.map(str::to_owned);
        let arguments = Arguments { debug: false, target: Some(target.to_owned()), glibc };
        platforms(&Build::new(&arguments).unwrap()).unwrap().join(".")
    }

    #[test]
    fn platforms_have_the_names_of_python() {
        assert_eq!(of("x86_64-unknown-linux-musl", None), "manylinux_2_17_x86_64.musllinux_1_1_x86_64");
        assert_eq!(of("aarch64-unknown-linux-musl", None), "manylinux_2_17_aarch64.musllinux_1_1_aarch64");
        assert_eq!(of("x86_64-unknown-linux-gnu", Some("2.17")), "manylinux_2_17_x86_64");
        assert_eq!(of("x86_64-unknown-linux-gnu", None), "linux_x86_64");
        assert_eq!(of("aarch64-apple-darwin", None), "macosx_11_0_arm64");
        assert_eq!(of("x86_64-pc-windows-msvc", None), "win_amd64");
    }

    #[test]
    fn the_notices_are_a_licence_of_the_wheel() {
        let metadata = "Name: val3\nLicense-File: LICENSE-MIT\nLicense-File: LICENSE-APACHE\nSummary: x\n";
        let added = "License-File: THIRD-PARTY.txt\nLicense-File: THIRD-PARTY-RUST.html\nSummary";
        let expected = metadata.replace("Summary", added);
        assert_eq!(with_notices(metadata).unwrap(), expected);
        assert!(with_notices("Name: val3\n").is_err());
    }
}
