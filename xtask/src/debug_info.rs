//! Splits the debug information off a binary. It is not part of the download, but stored for debugging.

use std::fs;
use std::process::Command;

use anyhow::Context;
use camino::{Utf8Path, Utf8PathBuf};

use crate::project;

/// A binary and its debug information.
pub struct Parts {
    /// Binary without line tables. Backtraces contain function names.
    pub binary: Utf8PathBuf,
    /// Line tables. Backtraces and debuggers find the file next to the binary. `None` if the linker already separates
    /// them (macOS, Windows).
    pub debug: Option<Utf8PathBuf>,
}

/// Splits the binary of a target into `folder`. The original file is not changed.
///
/// # Errors
/// The toolchain's `rust-objcopy` is missing or fails, or a file cannot be written.
pub fn split(binary: &Utf8Path, target: &str, folder: &Utf8Path) -> anyhow::Result<Parts> {
    if !target.contains("linux") {
        return Ok(Parts { binary: binary.to_owned(), debug: None });
    }
    fs::create_dir_all(folder).with_context(|| format!("cannot make {folder}"))?;
    let small = folder.join(binary.file_name().context("a binary has a name")?);
    let debug = small.with_extension("debug");
    objcopy(&["--only-keep-debug", binary.as_str(), debug.as_str()])?;
    let link = format!("--add-gnu-debuglink={debug}");
    objcopy(&["--strip-debug", &link, binary.as_str(), small.as_str()])?;
    Ok(Parts { binary: small, debug: Some(debug) })
}

fn objcopy(arguments: &[&str]) -> anyhow::Result<()> {
    let libraries = project::sysroot()?.join("lib");
    let program = libraries.join("rustlib").join(project::host()?).join("bin/rust-objcopy");
    project::succeed(Command::new(program).args(arguments).env("LD_LIBRARY_PATH", &libraries))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_stripped_binary_runs_and_is_smaller() {
        let folder = tempfile::tempdir().unwrap();
        let folder = Utf8Path::from_path(folder.path()).unwrap();
        let built = Utf8PathBuf::from_path_buf(std::env::current_exe().unwrap()).unwrap();
        let parts = split(&built, &project::host().unwrap(), folder).unwrap();
        let output = Command::new(&parts.binary).arg("--list").output().unwrap();
        assert!(output.status.success());
        let size = |path: &Utf8Path| fs::metadata(path).unwrap().len();
        if let Some(debug) = parts.debug {
            assert!(size(&parts.binary) < size(&built) / 2, "{} of {}", size(&parts.binary), size(&built));
            assert!(size(&debug) > size(&built) / 2);
        }
    }
}
