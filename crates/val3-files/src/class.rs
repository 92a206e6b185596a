//! Classes of files, each with the size up to which a file is read.

use std::sync::OnceLock;

/// A class of files.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FileClass {
    /// `val3.toml`, `.editorconfig`, scripts, scenarios, arms.
    Settings,
    /// Configuration files of a controller and tables of add-ons.
    Cell,
    /// Programs, data and project files.
    Program,
    /// The shape of a link of the arm.
    Shape,
    /// Files that the tools or a controller write: baselines, traces, event records, logs.
    Record,
}

/// Limit of `--max-file-size`, in bytes.
static RAISED: OnceLock<u64> = OnceLock::new();

/// Raises the limit of each class to at least this number of bytes, for the rest of the process. Only the first call has
/// an effect.
pub fn raise_limits(bytes: u64) {
    RAISED.get_or_init(|| bytes);
}

impl FileClass {
    /// Largest size of a file that is read, in bytes.
    pub fn limit(self) -> u64 {
        self.default_limit().max(RAISED.get().copied().unwrap_or(0))
    }

    fn default_limit(self) -> u64 {
        match self {
            Self::Settings => 1 << 20,
            Self::Cell => 16 << 20,
            Self::Program => 256 << 20,
            Self::Shape => 32 << 20,
            Self::Record => 1 << 30,
        }
    }
}
