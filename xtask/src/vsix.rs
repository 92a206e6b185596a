//! `vsix`: the VS Code extension with the server inside.

use std::fs;

use anyhow::{Context, bail};
use camino::{Utf8Path, Utf8PathBuf};

use crate::node::Node;
use crate::project;

/// Options of `vsix`, `dist` and `install`.
#[derive(clap::Args)]
pub struct Arguments {
    /// Build as for tests, without optimisation
    #[arg(long)]
    pub debug: bool,
}

/// Builds the server and packs it with the extension.
///
/// # Errors
/// When a build fails or there is no npm.
pub fn run(arguments: &Arguments) -> anyhow::Result<()> {
    // Before the build, which takes minutes.
    Node::find_or_install()?;
    println!("{}", extension(&binary(arguments)?, arguments)?);
    Ok(())
}

/// Builds `val3` and returns its path.
///
/// # Errors
/// When the build fails.
pub fn binary(arguments: &Arguments) -> anyhow::Result<Utf8PathBuf> {
    let packed = ["build", "--locked", "--package", "val3", "--profile", project::DIST];
    let which: &[&str] = if arguments.debug { &["build-val3"] } else { &packed };
    project::succeed(&mut project::cargo(which))?;
    project::binary(if arguments.debug { "debug" } else { project::DIST })
}

/// Packs the extension with `binary` as its server into `target/packages/val3-VERSION-PLATFORM.vsix`, for tests into
/// `target/editors/val3.vsix`.
///
/// # Errors
/// When there is no npm or a step of its build fails.
pub fn extension(binary: &Utf8Path, arguments: &Arguments) -> anyhow::Result<Utf8PathBuf> {
    let name = match arguments.debug {
        true => "editors/val3.vsix".to_owned(),
        false => format!("packages/val3-{}-{}.vsix", env!("CARGO_PKG_VERSION"), platform(&project::host()?)?),
    };
    pack(binary, &project::target_folder()?.join(name))
}

/// Packs the extension with `binary` as its server.
fn pack(binary: &Utf8Path, vsix: &Utf8Path) -> anyhow::Result<Utf8PathBuf> {
    let extension = project::root().join("editors/vscode");
    place_server(binary, &extension.join("server"))?;
    install_packages(&extension)?;
    npm(&extension, &["run", "--silent", "build"])?;
    fs::create_dir_all(vsix.parent().context("a file lies in a folder")?)?;
    let target = platform(&project::host()?)?;
    let package = ["exec", "--offline", "--", "vsce", "package", "--no-dependencies", "--target", target, "--out"];
    npm(&extension, &[&package[..], &[vsix.as_str()]].concat())?;
    Ok(vsix.to_owned())
}

fn place_server(binary: &Utf8Path, folder: &Utf8Path) -> anyhow::Result<()> {
    fs::create_dir_all(folder).with_context(|| format!("cannot make {folder}"))?;
    let server = folder.join(binary.file_name().context("a binary has a name")?);
    // A running server cannot be overwritten, but its file can be removed.
    if server.exists() {
        fs::remove_file(&server)?;
    }
    fs::copy(binary, &server).with_context(|| format!("cannot copy {binary} to {server}"))?;
    Ok(())
}

/// Installs what the lock file names, unless that was done already.
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
    // Standard output belongs to the task: it names the file that was made.
    npm.args(arguments).current_dir(folder).stdout(std::io::stderr());
    project::succeed(&mut npm)
}

/// VS Code's name of the platform that the compiler calls `host`.
fn platform(host: &str) -> anyhow::Result<&'static str> {
    let arm = host.starts_with("aarch64");
    Ok(match host {
        _ if host.contains("linux") && arm => "linux-arm64",
        _ if host.contains("linux") => "linux-x64",
        _ if host.contains("darwin") && arm => "darwin-arm64",
        _ if host.contains("darwin") => "darwin-x64",
        _ if host.contains("windows") && arm => "win32-arm64",
        _ if host.contains("windows") => "win32-x64",
        _ => bail!("VS Code does not run on {host}"),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn platforms_are_derived_from_the_host() {
        assert_eq!(platform("x86_64-unknown-linux-gnu").unwrap(), "linux-x64");
        assert_eq!(platform("aarch64-apple-darwin").unwrap(), "darwin-arm64");
        assert!(platform("wasm32-unknown-unknown").is_err());
    }
}
