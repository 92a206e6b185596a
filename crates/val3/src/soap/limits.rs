//! Limits that protect the run, and clients from each other.

use std::time::Duration;

use crate::http::ConnectionLimits;
use crate::serve::quota::RateLimits;

/// Limits of a server for clients of the SOAP interface.
#[derive(Debug, Clone, Copy)]
pub(super) struct SoapLimits {
    /// Connections. They are kept alive between requests.
    pub(super) connections: ConnectionLimits,
    /// Timeout for the body of a request.
    pub(super) body_time: Duration,
    /// Timeout for an answer of the run loop.
    pub(super) answer_time: Duration,
    /// Maximum size of a body, in bytes.
    pub(super) body_bytes: usize,
    /// Maximum number of requests that wait for the run loop.
    pub(super) waiting_calls: usize,
    /// Rate of the requests of all clients.
    pub(super) calls: RateLimits,
}

impl Default for SoapLimits {
    fn default() -> Self {
        Self {
            connections: ConnectionLimits {
                connections: 64,
                header_time: Duration::from_secs(30),
                connection_time: Duration::from_secs(600),
                last_request_time: Duration::from_secs(30),
            },
            body_time: Duration::from_secs(10),
            answer_time: Duration::from_secs(10),
            body_bytes: 1 << 20,
            waiting_calls: 256,
            calls: RateLimits { per_second: 5000, at_once: 10_000, refused: u32::MAX },
        }
    }
}
