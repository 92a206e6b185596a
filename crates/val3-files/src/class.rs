//! Classes of files with their limits, and the limit of a workspace.

use std::sync::OnceLock;

/// Class of a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FileClass {
    /// `val3.toml`, `.editorconfig`, scripts, scenarios, arms.
    Settings,
    /// Configuration files of a controller, and tables of add-ons.
    Cell,
    /// Programs, data and project files.
    Program,
    /// Shape of an arm link.
    Shape,
    /// Files written by the tools or a controller: baselines, traces, event records, logs.
    Record,
}

/// Limits that the user sets for the process.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct ProcessLimits {
    /// Minimum limit for all classes, in bytes (`--max-file-size`).
    pub file: Option<u64>,
    /// Limit of a workspace's programs and data, in bytes (`--max-workspace-size`).
    pub workspace: Option<u64>,
}

static LIMITS: OnceLock<ProcessLimits> = OnceLock::new();

/// Default limit of a workspace's programs and data, in bytes.
const DEFAULT_WORKSPACE: u64 = 2 << 30;

impl ProcessLimits {
    /// Sets the limits for the rest of the process. Only the first call has an effect.
    pub fn set(self) {
        LIMITS.get_or_init(|| self);
    }

    /// Limit of a workspace's programs and data, in bytes.
    pub fn workspace() -> u64 {
        Self::present().workspace.unwrap_or(DEFAULT_WORKSPACE)
    }

    fn present() -> Self {
        LIMITS.get().copied().unwrap_or_default()
    }
}

impl FileClass {
    /// Limit of the file size, in bytes.
    pub fn limit(self) -> u64 {
        self.default_limit().max(ProcessLimits::present().file.unwrap_or(0))
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
