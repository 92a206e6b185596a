//! Limits that prevent programs from filling the memory of the computer.

/// Maximum amounts of data that the devices store for programs, in bytes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct DeviceLimits {
    /// Events in a cycle. The cycle is then suspended, so that the caller can take the events.
    pub recorded: usize,
    /// Data that all tasks together have to send over lines. Beyond this limit, sending raises error 40.
    pub pending: usize,
    /// Size of the data that `libSave` writes. Beyond this limit, the instruction returns code 38.
    pub saved: u64,
    /// Files that programs have changed since external input is recorded, which stay in memory. Beyond this limit,
    /// writing fails.
    pub changed: u64,
}

impl Default for DeviceLimits {
    fn default() -> Self {
        Self { recorded: 64 << 20, pending: 64 << 20, saved: 64 << 20, changed: 256 << 20 }
    }
}
