//! `vsix`: the VS Code extension with the server inside.

use std::fs;

use anyhow::{Context, bail};
use camino::{Utf8Path, Utf8PathBuf};

use crate::build::{Arguments, Build};
use crate::node::Node;
use crate::notices;
use crate::project;

/// Folder of extensions below the target folder. The extensions that `dist` packs are in another folder.
pub const FOLDER: &str = "extension";

/// Folder in the repository to which relative links in the extension's readme refer.
const README_FOLDER: &str = "editors/vscode/";

/// Builds the server and packs it with the extension.
///
/// # Errors
/// A build fails or there is no npm.
pub fn run(arguments: &Arguments) -> anyhow::Result<()> {
    let build = Build::new(arguments)?;
    // Before the build, which needs minutes.
    Node::find_or_install()?;
    println!("{}", extension(&build, &build.parts()?.binary, FOLDER)?);
    Ok(())
}

/// Packs the extension with `binary` as its server into `val3-VERSION-PLATFORM.vsix` in a folder of the target folder,
/// for tests into `editors/val3.vsix`.
///
/// # Errors
/// There is no npm, or a build step fails.
pub fn extension(build: &Build, binary: &Utf8Path, folder: &str) -> anyhow::Result<Utf8PathBuf> {
    let name = match build.is_debug {
        true => "editors/val3.vsix".to_owned(),
        false => format!("{folder}/val3-{}-{}.vsix", env!("CARGO_PKG_VERSION"), platform(&build.target)?),
    };
    let vsix = project::target_folder()?.join(name);
    pack(build, binary, &vsix)?;
    Ok(vsix)
}

/// Packs the extension with `binary` as its server.
fn pack(build: &Build, binary: &Utf8Path, vsix: &Utf8Path) -> anyhow::Result<()> {
    let extension = project::root().join("editors/vscode");
    place_server(binary, &extension.join("server"))?;
    install_packages(&extension)?;
    // The tests check the types once, and pack the extension several times.
    npm(&extension, &["run", "--silent", "bundle"])?;
    let packages = project::read("editors/vscode/dist/notices.txt")?;
    let notices = format!("{}{packages}", notices::of_binary(&build.target)?);
    let target = extension.join("THIRD-PARTY.txt");
    fs::write(&target, notices).with_context(|| format!("cannot write {target}"))?;
    let (page, target) = (notices::of_standard_library()?, extension.join("THIRD-PARTY-RUST.html"));
    fs::copy(&page, &target).with_context(|| format!("cannot copy {page} to {target}"))?;
    fs::create_dir_all(vsix.parent().context("a file lies in a folder")?)?;
    // Links and pictures in the readme are relative to its folder in the repository.
    let repository = env!("CARGO_PKG_REPOSITORY");
    let version = env!("CARGO_PKG_VERSION");
    let links = format!("{repository}/blob/v{version}/{README_FOLDER}");
    let pictures = format!("{repository}/raw/v{version}/{README_FOLDER}");
    let package = ["exec", "--offline", "--", "vsce", "package", "--no-dependencies", "--target"];
    let options = [platform(&build.target)?, "--baseContentUrl", &links, "--baseImagesUrl", &pictures, "--out"];
    // Editors install the file while tests pack it again.
    let packed = vsix.with_extension("new.vsix");
    npm(&extension, &[&package[..], &options[..], &[packed.as_str()]].concat())?;
    fs::rename(&packed, vsix).with_context(|| format!("cannot rename {packed} to {vsix}"))
}

fn place_server(binary: &Utf8Path, folder: &Utf8Path) -> anyhow::Result<()> {
    // The folder may contain the server for another system. A running server cannot be overwritten, but its file can be
    // removed.
    if folder.exists() {
        fs::remove_dir_all(folder).with_context(|| format!("cannot clear {folder}"))?;
    }
    fs::create_dir_all(folder).with_context(|| format!("cannot make {folder}"))?;
    let server = folder.join(binary.file_name().context("a binary has a name")?);
    fs::copy(binary, &server).with_context(|| format!("cannot copy {binary} to {server}"))?;
    Ok(())
}

/// Installs the packages in the lock file, unless they are already installed.
fn install_packages(extension: &Utf8Path) -> anyhow::Result<()> {
    let changed = |file: &str| fs::metadata(extension.join(file)).and_then(|file| file.modified());
    let installed = changed("node_modules/.package-lock.json");
    let wanted = changed("package-lock.json").context("the lock file of the extension")?;
    if installed.is_ok_and(|installed| installed >= wanted) {
        return Ok(());
    }
    npm(extension, &["ci", "--ignore-scripts", "--no-audit", "--no-fund"])
}

fn npm(folder: &Utf8Path, arguments: &[&str]) -> anyhow::Result<()> {
    let mut npm = Node::find_or_install()?.npm()?;
    // Standard output belongs to the task, which prints the created file.
    npm.args(arguments).current_dir(folder).stdout(std::io::stderr());
    project::succeed(&mut npm)
}

/// Returns VS Code's name of a compiler target. A static binary runs on every Linux that VS Code supports.
fn platform(target: &str) -> anyhow::Result<&'static str> {
    let arm = target.starts_with("aarch64");
    Ok(match target {
        _ if target.contains("linux") && arm => "linux-arm64",
        _ if target.contains("linux") => "linux-x64",
        _ if target.contains("darwin") && arm => "darwin-arm64",
        _ if target.contains("darwin") => "darwin-x64",
        _ if target.contains("windows") && arm => "win32-arm64",
        _ if target.contains("windows") => "win32-x64",
        _ => bail!("VS Code does not run on {target}"),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn platforms_are_derived_from_the_target() {
        assert_eq!(platform("x86_64-unknown-linux-gnu").unwrap(), "linux-x64");
        assert_eq!(platform("aarch64-unknown-linux-musl").unwrap(), "linux-arm64");
        assert_eq!(platform("aarch64-apple-darwin").unwrap(), "darwin-arm64");
        assert!(platform("wasm32-unknown-unknown").is_err());
    }
}
