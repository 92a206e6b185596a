//! Content kinds of output, which determine how the filter changes it.

use std::io::{self, IsTerminal as _};

use super::commands;

/// Output kind by content. Output that a program must receive unchanged is changed only at a terminal.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum OutputContent {
    /// Human-readable text with names, paths and code: control characters are always replaced by visible forms.
    Words,
    /// Commands of a service; the format has escaped all texts.
    Commands,
    /// JSON, in which control characters can be escaped without a change in meaning.
    Json,
    /// Output of an application, or a patch: unchanged in files and pipes, but never a command of a service.
    Data,
    /// Content of a file: unchanged in files and pipes.
    File,
}

/// Output destination.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Destination {
    /// Whether it is a terminal.
    pub(super) is_terminal: bool,
    /// Whether a service executes commands in it.
    pub(super) reads_commands: bool,
}

impl Destination {
    /// A file.
    pub(crate) const FILE: Self = Self { is_terminal: false, reads_commands: false };

    /// The standard output. A service reads it unless it is redirected to a file.
    pub(crate) fn stdout() -> Self {
        let out = io::stdout();
        Self { is_terminal: out.is_terminal(), reads_commands: commands::are_read() && !is_file(&out) }
    }

    /// The standard error output, to which only [`OutputContent::Words`] are written.
    pub(super) fn stderr() -> Self {
        Self { is_terminal: io::stderr().is_terminal(), reads_commands: commands::are_read() }
    }
}

/// Whether the standard output is a regular file.
fn is_file(out: &io::Stdout) -> bool {
    #[cfg(unix)]
    let file = std::os::fd::AsFd::as_fd(out).try_clone_to_owned();
    #[cfg(windows)]
    let file = std::os::windows::io::AsHandle::as_handle(out).try_clone_to_owned();
    file.and_then(|file| std::fs::File::from(file).metadata()).is_ok_and(|metadata| metadata.is_file())
}

/// Treatment of control characters.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Controls {
    /// Unchanged.
    Kept,
    /// Replaced by visible forms.
    Pictured,
    /// Escaped as in JSON strings.
    Escaped,
}

impl OutputContent {
    /// Treatment of control characters for a destination.
    pub(super) fn controls(self, to: Destination) -> Controls {
        match self {
            Self::Words | Self::Commands => Controls::Pictured,
            Self::Json => Controls::Escaped,
            Self::Data | Self::File if to.is_terminal => Controls::Pictured,
            Self::Data | Self::File => Controls::Kept,
        }
    }

    /// Whether the filter breaks texts that a service would execute.
    pub(super) fn breaks_commands(self, to: Destination) -> bool {
        to.reads_commands && !matches!(self, Self::Commands | Self::File)
    }
}
