//! Builds `val3` for the packages, for this or another system.

use anyhow::bail;
use camino::{Utf8Path, Utf8PathBuf};

use crate::debug_info::{self, Parts};
use crate::packaging_tools::{self, Packages};
use crate::project;

/// Options of `vsix`, `dist` and `install`.
#[derive(clap::Args)]
pub struct Arguments {
    /// Build as for tests, without optimisation
    #[arg(long)]
    pub debug: bool,
    /// Build for this target of the compiler, for example `x86_64-unknown-linux-musl`. C code for musl is compiled with
    /// cargo-zigbuild
    #[arg(long, value_name = "TRIPLE", conflicts_with = "debug")]
    pub target: Option<String>,
    /// On Linux, link for this version of glibc and later ones with cargo-zigbuild, for example `2.17`
    #[arg(long, value_name = "VERSION", conflicts_with = "debug")]
    pub glibc: Option<String>,
}

/// Target and profile of a build.
pub struct Build {
    /// Compiler target.
    pub target: String,
    /// Oldest supported version of glibc; `None` for the version of the linker.
    pub glibc: Option<String>,
    /// Whether this is the build of the tests.
    pub is_debug: bool,
    /// Whether the target is given on the command line, so that cargo uses a separate folder for it.
    is_named: bool,
}

impl Build {
    /// Creates the build that the command line describes.
    ///
    /// # Errors
    /// The host is unknown, or a version of glibc is given for a target without glibc.
    pub fn new(arguments: &Arguments) -> anyhow::Result<Self> {
        let target = arguments.target.clone().map_or_else(project::host, Ok)?;
        if arguments.glibc.is_some() && !target.ends_with("-linux-gnu") {
            bail!("`--glibc` is for targets with glibc, and {target} has none");
        }
        let is_named = arguments.target.is_some() || arguments.glibc.is_some();
        Ok(Self { target, glibc: arguments.glibc.clone(), is_debug: arguments.debug, is_named })
    }

    /// Whether the binary is for Windows.
    #[must_use]
    pub fn is_for_windows(&self) -> bool {
        self.target.contains("windows")
    }

    /// Returns the file name of the command.
    #[must_use]
    pub fn command(&self) -> &'static str {
        if self.is_for_windows() { "val3.exe" } else { "val3" }
    }

    /// Builds `val3`, splits off the debug information, and returns both.
    ///
    /// # Errors
    /// The build or the split fails.
    pub fn parts(&self) -> anyhow::Result<Parts> {
        let binary = self.binary()?;
        let folder = binary.parent().unwrap_or(&binary).join("parts");
        debug_info::split(&binary, &self.target, &folder)
    }

    /// Whether cargo-zigbuild compiles C code and links: for an older glibc, and for musl, for which systems with another C
    /// library have no C compiler.
    fn needs_zig(&self) -> bool {
        self.glibc.is_some() || self.is_named && self.target.ends_with("-linux-musl")
    }

    /// Returns the arguments of cargo for this build, without the command.
    pub fn cargo_arguments(&self) -> Vec<String> {
        let mut arguments: Vec<String> =
            ["--locked", "--package", "val3", "--profile", project::DIST].map(str::to_owned).into();
        if self.is_named {
            let glibc = self.glibc.as_ref().map(|version| format!(".{version}")).unwrap_or_default();
            arguments.extend(["--target".to_owned(), format!("{}{glibc}", self.target)]);
        }
        arguments
    }

    /// Builds `val3` and returns its path.
    fn binary(&self) -> anyhow::Result<Utf8PathBuf> {
        if self.is_debug {
            project::succeed(&mut project::cargo(&["build-val3"]))?;
        } else if self.needs_zig() {
            let mut build = packaging_tools::command(Packages::Zig, "cargo-zigbuild")?;
            project::succeed(build.arg("zigbuild").args(self.cargo_arguments()))?;
        } else {
            project::succeed(project::cargo(&["build"]).args(self.cargo_arguments()))?;
        }
        let profile = if self.is_debug { "debug" } else { project::DIST };
        let folder = if self.is_named { Utf8Path::new(&self.target) } else { Utf8Path::new("") };
        Ok(project::target_folder()?.join(folder).join(profile).join(self.command()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn build(target: Option<&str>, glibc: Option<&str>) -> anyhow::Result<Build> {
        let text = |value: Option<&str>| value.map(str::to_owned);
        Build::new(&Arguments { debug: false, target: text(target), glibc: text(glibc) })
    }

    #[test]
    fn a_named_target_is_passed_to_cargo() {
        let host = build(None, None).unwrap();
        assert_eq!(host.cargo_arguments().last().unwrap(), project::DIST);
        let musl = build(Some("aarch64-unknown-linux-musl"), None).unwrap();
        assert_eq!(musl.cargo_arguments().last().unwrap(), "aarch64-unknown-linux-musl");
        let old = build(Some("x86_64-unknown-linux-gnu"), Some("2.17")).unwrap();
        assert_eq!(old.cargo_arguments().last().unwrap(), "x86_64-unknown-linux-gnu.2.17");
    }

    #[test]
    fn targets_without_a_compiler_of_the_system_are_built_with_zig() {
        assert!(build(Some("x86_64-unknown-linux-musl"), None).unwrap().needs_zig());
        assert!(build(Some("x86_64-unknown-linux-gnu"), Some("2.17")).unwrap().needs_zig());
        for target in [None, Some("x86_64-unknown-linux-gnu"), Some("x86_64-pc-windows-msvc")] {
            assert!(!build(target, None).unwrap().needs_zig(), "{target:?}");
        }
    }

    #[test]
    fn glibc_is_for_targets_with_glibc() {
        let Err(error) = build(Some("x86_64-pc-windows-msvc"), Some("2.17")) else { panic!("it was accepted") };
        assert_eq!(error.to_string(), "`--glibc` is for targets with glibc, and x86_64-pc-windows-msvc has none");
    }

    #[test]
    fn the_command_of_windows_has_an_ending() {
        assert_eq!(build(Some("x86_64-pc-windows-msvc"), None).unwrap().command(), "val3.exe");
        assert_eq!(build(Some("x86_64-unknown-linux-musl"), None).unwrap().command(), "val3");
    }
}
