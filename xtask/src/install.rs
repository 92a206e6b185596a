//! `install`: the command `val3` for the user, and the extension for the user's VS Code.

use std::process::Command;

use anyhow::bail;
use camino::Utf8Path;

use crate::build::{Arguments, Build};
use crate::node::Node;
use crate::project;
use crate::vsix;

/// Editors that install the extension, by their commands.
const EDITORS: &[&str] = &["code", "codium", "code-server"];

/// Builds and installs the binary where cargo installs binaries, and the extension in each editor that is found.
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
    let install = ["install", "--path", "crates/val3", "--locked"];
    let profile: &[&str] = if arguments.debug { &["--debug"] } else { &["--profile", project::DIST] };
    project::succeed(&mut project::cargo(&[&install, profile].concat()))?;
    if editors.is_empty() {
        println!("The PATH has no VS Code (`{}`). `cargo xtask vsix` makes the extension.", EDITORS.join("`, `"));
        return Ok(());
    }
    let build = Build::new(arguments)?;
    let vsix = vsix::extension(&build, &build.parts()?.binary, vsix::FOLDER)?;
    editors.iter().try_for_each(|editor| install_extension(editor, &vsix))
}

fn install_extension(editor: &str, vsix: &Utf8Path) -> anyhow::Result<()> {
    project::succeed(Command::new(editor).args(["--install-extension", vsix.as_str(), "--force"]))
}
