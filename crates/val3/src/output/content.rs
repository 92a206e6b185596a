//! Kinds of output, which decide how it is changed for its reader.

use std::io::{self, IsTerminal as _};

use super::commands;

/// A kind of output. Those that must reach a program unchanged are changed only where a terminal shows them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Content {
    /// Texts for people, with names, paths and code: control characters are always visible.
    Words,
    /// Commands of a service, in which the format has escaped all texts.
    Commands,
    /// JSON, in which control characters can be escaped without a change of its meaning.
    Json,
    /// The output of an application, or a patch: unchanged in files and pipes, but never a command of a service.
    Data,
    /// The content of a file: unchanged in files and pipes.
    File,
}

/// The destination of an output.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Destination {
    /// Whether it is a terminal.
    pub(super) is_terminal: bool,
    /// Whether a service reads commands from it.
    pub(super) reads_commands: bool,
}

impl Destination {
    /// A file.
    pub(crate) const FILE: Self = Self { is_terminal: false, reads_commands: false };

    /// The standard output. A service reads it unless it was redirected to a file.
    pub(crate) fn stdout() -> Self {
        let out = io::stdout();
        Self { is_terminal: out.is_terminal(), reads_commands: commands::are_read() && !is_file(&out) }
    }

    /// The standard error output, on which only words are written.
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

/// The treatment of control characters.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Controls {
    /// Unchanged.
    Kept,
    /// Replaced by visible forms.
    Pictured,
    /// Escaped as in strings of JSON.
    Escaped,
}

impl Content {
    /// The treatment of control characters on the way to a destination.
    pub(super) fn controls(self, to: Destination) -> Controls {
        match self {
            Self::Words | Self::Commands => Controls::Pictured,
            Self::Json => Controls::Escaped,
            Self::Data | Self::File if to.is_terminal => Controls::Pictured,
            Self::Data | Self::File => Controls::Kept,
        }
    }

    /// Whether texts that a service would execute are changed on the way to a destination.
    pub(super) fn breaks_commands(self, to: Destination) -> bool {
        to.reads_commands && !matches!(self, Self::Commands | Self::File)
    }
}
