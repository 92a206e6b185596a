//! Errors when an application is opened.

use std::fmt::{self, Display};

use camino::Utf8PathBuf;
use val3_analysis::load::LoadError;
use val3_compile::CompileError;
use val3_config::{ConfigError, ConfigFile};
use val3_lang::memory::MEMORY;

/// Reason why an application cannot be opened. `Display` states the fault and its location, [`help`](Self::help) the
/// remedy.
#[derive(Debug)]
pub enum SessionError {
    /// A path contains no application, or a `val3.toml` is invalid.
    Load(LoadError),
    /// A path contains several applications.
    Several {
        /// The path.
        path: Utf8PathBuf,
        /// Folders of the applications, relative to the path.
        applications: Vec<String>,
    },
    /// A setting has an invalid value. The message states its location.
    Setting {
        /// The fault.
        message: String,
        /// The remedy; may be empty.
        help: String,
    },
    /// A folder cannot be opened.
    Folder {
        /// Root name, without `://`.
        root: String,
        /// The folder.
        folder: Utf8PathBuf,
        /// Reason from the operating system.
        reason: String,
    },
    /// A file of the application or the cell exists but cannot be read.
    UnreadableFile {
        /// The file.
        file: Utf8PathBuf,
        /// The reason.
        reason: String,
    },
    /// A serial line or socket rejects its configuration.
    Line {
        /// Line name in the cell, for example `Socket\host`.
        link: String,
    },
    /// A connection names a line that neither the cell nor the application has.
    UnknownLine {
        /// Line name of the connection.
        link: String,
        /// Names of all lines, sorted.
        known: Vec<String>,
    },
    /// A serial device cannot be opened.
    Device {
        /// The device.
        device: Utf8PathBuf,
        /// Line name.
        link: String,
        /// The reason.
        reason: String,
    },
    /// A recorded run cannot be replayed.
    Recording {
        /// The file.
        file: Utf8PathBuf,
        /// The reason.
        reason: String,
    },
    /// The data of the application exceed the memory of a controller.
    Memory,
    /// The application exceeds a limit of the virtual controller.
    Limit(CompileError),
    /// A variable declaration is invalid, or the application has faults that prevent the declaration of variables.
    Variables {
        /// The fault.
        message: String,
        /// The remedy; may be empty.
        help: String,
    },
}

impl From<ConfigError> for SessionError {
    fn from(error: ConfigError) -> Self {
        Self::Load(LoadError::Configuration(vec![error]))
    }
}

/// Returns the error of a key in a `val3.toml` whose value cannot be used.
pub(crate) fn refused(file: &ConfigFile, key: &str, message: String, help: &str) -> SessionError {
    file.fault(key, message, help.to_owned()).into()
}

impl SessionError {
    /// The remedy; may be empty.
    pub fn help(&self) -> String {
        match self {
            Self::Load(_) => String::new(),
            Self::Several { applications, .. } => {
                let listed = applications.join(", ");
                format!("name the folder of one of them: {listed}; or set `[run.default] application` in val3.toml")
            }
            Self::Setting { help, .. } | Self::Variables { help, .. } => help.clone(),
            Self::Folder { .. } => "name a folder that you may read".to_owned(),
            Self::UnreadableFile { .. } => {
                "correct it, allow reading it, or copy it from the controller again".to_owned()
            }
            Self::Line { .. } => "look at its parameters in sio.cfx, at --line and at [run] in val3.toml".to_owned(),
            Self::UnknownLine { known, .. } if known.is_empty() => {
                "link a variable of the type `sio` to it, or declare it in usr/configs/sio.cfx".to_owned()
            }
            Self::UnknownLine { known, .. } => format!("name one of these lines: {}", known.join(", ")),
            Self::Device { .. } => "name a serial device that you may read and write".to_owned(),
            Self::Recording { .. } => "name a file that `val3 run --events` has written".to_owned(),
            Self::Memory => "reduce array sizes, or read large data from files".to_owned(),
            Self::Limit(error) => error.limit.help().to_owned(),
        }
    }
}

impl Display for SessionError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Load(error) => error.fmt(f),
            Self::Several { path, applications } => write!(f, "`{path}` holds {} applications", applications.len()),
            Self::Setting { message, .. } | Self::Variables { message, .. } => f.write_str(message),
            Self::Folder { root, folder, reason } => {
                write!(f, "cannot open the folder `{folder}` for `{root}://`: {reason}")
            }
            Self::UnreadableFile { file, reason } => write!(f, "cannot read `{file}`: {reason}"),
            Self::Line { link } => write!(f, "the line `{link}` does not accept this configuration"),
            Self::UnknownLine { link, .. } => write!(f, "neither the cell nor the application has a line `{link}`"),
            Self::Device { device, link, reason } => {
                write!(f, "cannot open the device `{device}` for `{link}`: {reason}")
            }
            Self::Recording { file, reason } => write!(f, "cannot replay `{file}`: {reason}"),
            Self::Memory => {
                write!(f, "the data of the application need more memory than a controller has ({} MB)", MEMORY >> 20)
            }
            Self::Limit(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for SessionError {}

impl From<CompileError> for SessionError {
    fn from(error: CompileError) -> Self {
        Self::Limit(error)
    }
}

impl From<LoadError> for SessionError {
    fn from(error: LoadError) -> Self {
        Self::Load(error)
    }
}
