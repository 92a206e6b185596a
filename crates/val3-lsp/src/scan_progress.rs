//! How far the first check has come, as the client shows it.

/// The progress of the first check.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(crate) enum ScanProgress {
    /// Not begun.
    #[default]
    Before,
    /// The client was asked whether it shows it.
    Asked,
    /// The client shows it.
    Shown,
    /// It is over, or the client does not show it.
    Over,
}
