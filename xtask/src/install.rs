//! `install`: the command `val3` for this user, and the extension for their VS Code.

use std::process::Command;

use camino::Utf8Path;

use crate::node::Node;
use crate::project;
use crate::vsix::{self, Arguments};

/// Editors that take the extension, by their commands.
const EDITORS: &[&str] = &["code", "codium", "code-server"];

/// Builds and installs the binary where cargo installs binaries, and the extension in each editor that is found.
///
/// # Errors
/// When a build or an installation fails.
pub fn run(arguments: &Arguments) -> anyhow::Result<()> {
    let editors: Vec<&str> = EDITORS.iter().copied().filter(|editor| is_command(editor)).collect();
    if !editors.is_empty() {
        // Before the build, which takes minutes.
        Node::find_or_install()?;
    }
    let install = ["install", "--path", "crates/val3", "--locked"];
    let profile: &[&str] = if arguments.debug { &["--debug"] } else { &["--profile", project::DIST] };
    project::succeed(&mut project::cargo(&[&install, profile].concat()))?;
    if editors.is_empty() {
        println!("No VS Code was found on the PATH. `cargo xtask vsix` makes the extension.");
        return Ok(());
    }
    let vsix = vsix::extension(&vsix::binary(arguments)?, arguments)?;
    editors.into_iter().try_for_each(|editor| install_extension(editor, &vsix))
}

fn is_command(name: &str) -> bool {
    Command::new(name).arg("--version").output().is_ok_and(|output| output.status.success())
}

fn install_extension(editor: &str, vsix: &Utf8Path) -> anyhow::Result<()> {
    project::succeed(Command::new(editor).args(["--install-extension", vsix.as_str(), "--force"]))
}
