//! The limits that keep viewers from each other and from the run.

use std::time::Duration;

/// The limits of a server.
#[derive(Debug, Clone)]
pub(super) struct ServerLimits {
    /// Viewers at the same time.
    pub(super) viewers: usize,
    /// Connections that have not become viewers.
    pub(super) connections: usize,
    /// The time for the header of a request.
    pub(super) header_time: Duration,
    /// The time for a request and its answer, without the socket that may follow.
    pub(super) request_time: Duration,
    /// The time for one message to a viewer whose buffers are full.
    pub(super) send_time: Duration,
    /// The time between two pings.
    pub(super) ping_time: Duration,
    /// The time after which a viewer without a sign of life is gone.
    pub(super) silence: Duration,
    /// The time for viewers to read the last messages when the server ends.
    pub(super) action_after_disconnect: Duration,
    /// The largest message of a viewer in bytes.
    pub(super) message_bytes: usize,
    /// Commands of a viewer in the long run.
    pub(super) commands_per_second: u16,
    /// Commands of a viewer at once.
    pub(super) commands_at_once: u16,
    /// Refused commands after which a viewer is disconnected.
    pub(super) refused_commands: u32,
    /// Bytes of the log of the run.
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
            action_after_disconnect: Duration::from_secs(1),
            message_bytes: 64 << 10,
            commands_per_second: 100,
            commands_at_once: 200,
            refused_commands: 1000,
            log_bytes: 256 << 20,
        }
    }
}
