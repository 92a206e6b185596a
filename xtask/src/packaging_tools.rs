//! Python packages for packaging: each list in `packaging` has an environment in `target/packaging`, which is created
//! once per content of the list.

use std::fs;
use std::process::Command;

use anyhow::Context;
use camino::Utf8PathBuf;

use crate::node;
use crate::project;

/// Folder with the programs of a Python environment.
const PROGRAMS: &str = if cfg!(windows) { "Scripts" } else { "bin" };

/// A list of packages.
#[derive(Clone, Copy)]
pub enum Packages {
    /// Tools for wheels: `packaging/wheel.txt`.
    Wheel,
    /// C compiler and linker for older systems and for musl: `packaging/zig.txt`.
    Zig,
}

impl Packages {
    fn name(self) -> &'static str {
        match self {
            Self::Wheel => "wheel",
            Self::Zig => "zig",
        }
    }
}

/// Returns the command for program `name` in an environment, to be run in the project's folder.
///
/// # Errors
/// Python is missing or the packages cannot be installed.
pub fn command(packages: Packages, name: &str) -> anyhow::Result<Command> {
    let programs = environment(packages)?.join(PROGRAMS);
    let mut search = vec![programs.clone().into_std_path_buf()];
    search.extend(std::env::split_paths(&std::env::var_os("PATH").unwrap_or_default()));
    let mut command = Command::new(programs.join(format!("{name}{}", std::env::consts::EXE_SUFFIX)));
    // cargo-zigbuild finds zig as a module of the first Python on the search path.
    command.env("PATH", std::env::join_paths(search)?).current_dir(project::root());
    Ok(command)
}

/// Returns an environment's folder, in which the packages are installed.
fn environment(packages: Packages) -> anyhow::Result<Utf8PathBuf> {
    let folder = project::target_folder()?.join("packaging").join(packages.name());
    let requirements = project::root().join(format!("packaging/{}.txt", packages.name()));
    let wanted = fs::read(&requirements).with_context(|| format!("cannot read {requirements}"))?;
    let installed = folder.join("installed");
    if fs::read(&installed).is_ok_and(|installed| installed == wanted) {
        return Ok(folder);
    }
    let python = node::python().context("packing needs Python 3.11 with venv, and there is none on the PATH")?;
    project::succeed(Command::new(python).args(["-m", "venv", "--clear", folder.as_str()]))?;
    let mut install = Command::new(folder.join(PROGRAMS).join("python"));
    install.args(["-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--requirement"]);
    project::succeed(install.arg(&requirements))?;
    fs::write(&installed, wanted).with_context(|| format!("cannot write {installed}"))?;
    Ok(folder)
}
