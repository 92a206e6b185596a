//! Settings of the connections to a server.

use std::time::Duration;

use crate::certificate::CertificateFingerprint;

/// How the connections to a server are made. A project remembers them.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct ConnectionSettings {
    /// Fingerprint of the accepted certificate; only for an address with TLS.
    pub fingerprint: Option<CertificateFingerprint>,
    /// Whether the controller opens the data connections (active mode), instead of this computer.
    pub is_active: bool,
}

/// Time limits of a connection.
#[derive(Debug, Clone, Copy)]
pub struct FtpTimeouts {
    /// For the connection.
    pub connect: Duration,
    /// Without a byte, for replies and transfers.
    pub transfer: Duration,
}

impl Default for FtpTimeouts {
    fn default() -> Self {
        Self { connect: Duration::from_secs(5), transfer: Duration::from_secs(30) }
    }
}
