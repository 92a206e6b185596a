//! Limits that protect the run, and viewers from each other.

use std::time::Duration;

use super::quota::RateLimits;

/// Server limits.
#[derive(Debug, Clone)]
pub(super) struct ServerLimits {
    /// Maximum number of simultaneous viewers.
    pub(super) viewers: usize,
    /// Maximum number of connections that are not viewers.
    pub(super) connections: usize,
    /// Timeout for a request header.
    pub(super) header_time: Duration,
    /// Timeout for a request and its response, excluding a socket that may follow.
    pub(super) request_time: Duration,
    /// Timeout for one message to a viewer whose buffers are full.
    pub(super) send_time: Duration,
    /// Time between two pings.
    pub(super) ping_time: Duration,
    /// Time without any frame after which a viewer is disconnected.
    pub(super) silence: Duration,
    /// Time in which viewers can read the last messages when the server ends.
    pub(super) farewell_time: Duration,
    /// Maximum size of a viewer's message, in bytes.
    pub(super) message_bytes: usize,
    /// Rate of a viewer's commands.
    pub(super) commands: RateLimits,
    /// Maximum size of the log, in bytes.
    pub(super) log_bytes: usize,
}

impl Default for ServerLimits {
    fn default() -> Self {
        Self {
            viewers: 32,
            connections: 64,
            header_time: Duration::from_secs(5),
            request_time: Duration::from_secs(30),
            send_time: Duration::from_secs(5),
            ping_time: Duration::from_secs(5),
            silence: Duration::from_secs(15),
            farewell_time: Duration::from_secs(1),
            message_bytes: 64 << 10,
            commands: RateLimits { per_second: 100, at_once: 200, refused: 1000 },
            log_bytes: 256 << 20,
        }
    }
}
