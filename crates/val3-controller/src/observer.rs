//! Progress and interruption of a transfer.

use crate::path::ControllerPath;

/// Step of a transfer.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TransferStep {
    /// Listing the folders of the controller.
    List,
    /// Downloading files.
    Download,
    /// Downloading the files that a push replaces.
    BackUp,
    /// Uploading files under temporary names.
    Upload,
    /// Giving uploaded files their names.
    Rename,
    /// Reading changed files again.
    Verify,
    /// Restoring files from the backup.
    Restore,
}

/// Receiver of the progress. It also decides whether the transfer ends early.
pub trait TransferObserver {
    /// A step begins; `files` is the expected file count, or 0 if it is unknown.
    fn step(&mut self, step: TransferStep, files: usize);

    /// A file was transferred or renamed; `bytes` is the size of the transferred content.
    fn file(&mut self, path: &ControllerPath, bytes: u64);

    /// Whether the user has interrupted the transfer.
    fn is_interrupted(&self) -> bool;
}

/// Fails if the user has interrupted the transfer.
pub(crate) fn check_interrupt(observer: &dyn TransferObserver) -> Result<(), crate::error::ControllerError> {
    if observer.is_interrupted() { Err(crate::error::ControllerError::Interrupted) } else { Ok(()) }
}

/// Observer without an effect.
#[derive(Debug, Clone, Copy, Default)]
pub struct SilentObserver;

impl TransferObserver for SilentObserver {
    fn step(&mut self, _: TransferStep, _: usize) {}

    fn file(&mut self, _: &ControllerPath, _: u64) {}

    fn is_interrupted(&self) -> bool {
        false
    }
}
