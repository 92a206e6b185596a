//! The folder of the project, and execution of its commands.

use std::process::Command;

use anyhow::{Context, bail};
use camino::{Utf8Path, Utf8PathBuf};
use cargo_metadata::MetadataCommand;

/// Returns the folder of the workspace's `Cargo.toml`.
pub fn root() -> Utf8PathBuf {
    let xtask = Utf8Path::new(env!("CARGO_MANIFEST_DIR"));
    xtask.parent().unwrap_or(xtask).to_owned()
}

/// Returns `cargo` with `arguments`, in the project's folder.
pub fn cargo(arguments: &[&str]) -> Command {
    let mut command = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    command.args(arguments).current_dir(root());
    command
}

/// Runs `command` to its end.
///
/// # Errors
/// The command cannot be started or does not succeed.
pub fn succeed(command: &mut Command) -> anyhow::Result<()> {
    let name = command.get_program().to_string_lossy().into_owned();
    let status = command.status().with_context(|| format!("cannot start {name}"))?;
    if !status.success() {
        bail!("{name} ended with {status}");
    }
    Ok(())
}

/// Returns the command `name` as Windows finds it: npm and VS Code are scripts there, whose ending Rust does not add.
#[must_use]
pub fn script(name: &str) -> String {
    if cfg!(windows) { format!("{name}.cmd") } else { name.to_owned() }
}

/// Whether a command with this name starts.
#[must_use]
pub fn is_command(name: &str) -> bool {
    Command::new(name).arg("--version").output().is_ok_and(|output| output.status.success())
}

/// Reads a file of the project; `path` is relative to its folder.
///
/// # Errors
/// The file cannot be read as UTF-8.
pub fn read(path: &str) -> anyhow::Result<String> {
    let path = root().join(path);
    std::fs::read_to_string(&path).with_context(|| format!("cannot read {path}"))
}

/// Returns the folder in which cargo builds.
///
/// # Errors
/// The workspace cannot be read.
pub fn target_folder() -> anyhow::Result<Utf8PathBuf> {
    let metadata = MetadataCommand::new().current_dir(root()).no_deps().exec()?;
    Ok(metadata.target_directory)
}

/// Profile of packed and measured binaries.
pub const DIST: &str = "dist";

/// Returns the `val3` that cargo builds, in the folder of a profile: `debug` or [`DIST`].
///
/// # Errors
/// The workspace cannot be read.
pub fn binary(profile: &str) -> anyhow::Result<Utf8PathBuf> {
    Ok(target_folder()?.join(profile).join(format!("val3{}", std::env::consts::EXE_SUFFIX)))
}

/// Returns the folder of the toolchain.
///
/// # Errors
/// The compiler cannot be started.
pub fn sysroot() -> anyhow::Result<Utf8PathBuf> {
    let output = Command::new("rustc").args(["--print", "sysroot"]).current_dir(root()).output();
    let text = String::from_utf8(output.context("cannot start rustc")?.stdout)?;
    Ok(text.trim_end().into())
}

/// Returns the target for which the compiler builds: `x86_64-unknown-linux-gnu`.
///
/// # Errors
/// The compiler cannot be started.
pub fn host() -> anyhow::Result<String> {
    let output = Command::new("rustc").arg("-vV").output().context("cannot start rustc")?;
    let text = String::from_utf8(output.stdout)?;
    let host = text.lines().find_map(|line| line.strip_prefix("host: "));
    Ok(host.context("rustc does not name its host")?.to_owned())
}
