//! `install`: the command `val3` for the user, and the extension for the user's VS Code.

use std::process::Command;
use std::{env, fs};

use anyhow::{Context, bail};
use camino::{Utf8Path, Utf8PathBuf};

use crate::build::{Arguments, Build};
use crate::node::Node;
use crate::project;
use crate::vsix;

/// Editors that install the extension, by their commands.
const EDITORS: &[&str] = &["code", "codium", "code-server"];

/// Builds and installs the binary where cargo installs binaries, and the extension in each editor that is found. With
/// `--debug` the binary of the tests is copied, because `cargo install` would build all dependencies again with the
/// features that only `val3` needs.
///
/// # Errors
/// A build or an installation fails, or an editor was found and there is no npm.
pub fn run(arguments: &Arguments) -> anyhow::Result<()> {
    if arguments.target.is_some() || arguments.glibc.is_some() {
        bail!("`install` is for this system: `--target` and `--glibc` are options of `dist` and `vsix`");
    }
    let editors: Vec<String> =
        EDITORS.iter().map(|editor| project::script(editor)).filter(|editor| project::is_command(editor)).collect();
    if !editors.is_empty() {
        // Before the build, which needs minutes.
        Node::find_or_install()?;
    }
    let build = Build::new(arguments)?;
    if arguments.debug {
        copy_command(&build)?;
    } else {
        let install = ["install", "--path", "crates/val3", "--locked", "--profile", project::DIST];
        project::succeed(&mut project::cargo(&install))?;
    }
    if editors.is_empty() {
        println!("The PATH has no VS Code (`{}`). `cargo xtask vsix` makes the extension.", EDITORS.join("`, `"));
        return Ok(());
    }
    let vsix = vsix::extension(&build, &build.parts()?.binary, vsix::FOLDER)?;
    editors.iter().try_for_each(|editor| install_extension(editor, &vsix))
}

fn copy_command(build: &Build) -> anyhow::Result<()> {
    let folder = binaries(|name| env::var(name).ok())?;
    let copy = folder.join(build.command());
    fs::create_dir_all(&folder).with_context(|| format!("cannot create {folder}"))?;
    fs::copy(build.parts()?.binary, &copy).with_context(|| format!("cannot write {copy}"))?;
    Ok(())
}

/// Returns the folder where cargo installs binaries, from the environment.
fn binaries(variable: impl Fn(&str) -> Option<String>) -> anyhow::Result<Utf8PathBuf> {
    let home = || variable(if cfg!(windows) { "USERPROFILE" } else { "HOME" }).map(|home| format!("{home}/.cargo"));
    let root = variable("CARGO_INSTALL_ROOT").or_else(|| variable("CARGO_HOME")).or_else(home);
    Ok(Utf8PathBuf::from(root.context("neither CARGO_HOME nor the home folder is set")?).join("bin"))
}

fn install_extension(editor: &str, vsix: &Utf8Path) -> anyhow::Result<()> {
    project::succeed(Command::new(editor).args(["--install-extension", vsix.as_str(), "--force"]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_root_of_cargo_comes_before_its_home_and_the_users() {
        let folder = |set: &'static [(&str, &str)]| {
            binaries(|name| set.iter().find(|(key, _)| *key == name).map(|(_, value)| (*value).to_owned()))
        };
        let all = &[("CARGO_INSTALL_ROOT", "/root"), ("CARGO_HOME", "/cargo"), ("HOME", "/me"), ("USERPROFILE", "/me")];
        assert_eq!(folder(all).unwrap(), "/root/bin");
        assert_eq!(folder(&all[1..]).unwrap(), "/cargo/bin");
        assert_eq!(folder(&all[2..]).unwrap(), "/me/.cargo/bin");
        assert!(folder(&[]).is_err());
    }
}
