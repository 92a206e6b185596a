//! Tools of the steps, which are installed while cargo already builds.

use std::ffi::OsString;
use std::process::{Child, Command, Stdio};
use std::thread::{self, JoinHandle};

use anyhow::{Context, bail};

use super::EDITORS;
use crate::node::Node;
use crate::{project, requirements};

/// The installation of tools, and its result.
pub(super) struct Tools {
    state: State,
    has_editors: bool,
    /// Installation of editors, which uses the other tools.
    editors: Option<Child>,
}

enum State {
    Installing(JoinHandle<anyhow::Result<OsString>>),
    /// `PATH` of steps.
    Installed(OsString),
    Failed,
}

impl Tools {
    /// Begins to install the tools of the steps. Missing system packages are listed first.
    ///
    /// # Errors
    /// The steps need packages that cannot be installed here.
    pub(super) fn prepare(steps: &[&str]) -> anyhow::Result<Self> {
        let packages = requirements::missing(steps)?;
        let has_editors = steps.contains(&EDITORS);
        let installation = thread::spawn(move || install(&packages, has_editors));
        Ok(Self { state: State::Installing(installation), has_editors, editors: None })
    }

    /// Starts the installation of editors as soon as the other tools are installed.
    ///
    /// # Errors
    /// The tools cannot be installed.
    pub(super) fn advance(&mut self) -> anyhow::Result<()> {
        if matches!(&self.state, State::Installing(thread) if thread.is_finished()) {
            self.path().map(drop)
        } else {
            Ok(())
        }
    }

    /// Returns the `PATH` of steps, after the end of the installation.
    ///
    /// # Errors
    /// The tools cannot be installed.
    pub(super) fn path(&mut self) -> anyhow::Result<OsString> {
        match std::mem::replace(&mut self.state, State::Failed) {
            State::Installing(thread) => {
                let path = thread.join().unwrap_or_else(|_| bail!("the installation has panicked"))?;
                self.editors = if self.has_editors { Some(install_editors(&path)?) } else { None };
                self.state = State::Installed(path.clone());
                Ok(path)
            }
            State::Installed(path) => {
                self.state = State::Installed(path.clone());
                Ok(path)
            }
            State::Failed => bail!("the tools of this step could not be installed, see above"),
        }
    }

    /// Waits for the end of installations that no step has awaited.
    ///
    /// # Errors
    /// They cannot be awaited.
    pub(super) fn close(mut self) -> anyhow::Result<()> {
        // If an installation has failed, the steps that need it have failed.
        if let Some(mut editors) = self.editors.take() {
            editors.wait()?;
        }
        Ok(())
    }
}

/// Installs packages and, for the editor tests, Node. Returns the search path for commands.
fn install(packages: &[&str], has_editors: bool) -> anyhow::Result<OsString> {
    requirements::install(packages)?;
    let node = if has_editors { Node::find_or_install()? } else { Node { folder: None } };
    node.path()
}

/// Begins to install the tools of the editor tests. The step waits for the end, and reports failures.
fn install_editors(path: &OsString) -> anyhow::Result<Child> {
    let mut install = Command::new(project::root().join("tests/editors/install"));
    install.env("VAL3_TOOLS", project::target_folder()?.join("editors")).env("PATH", path).stdout(Stdio::null());
    install.spawn().context("cannot start tests/editors/install")
}
