//! TLS of the control and data connections, with one accepted certificate.
//!
//! Certificates of controllers are usually self-signed and name no host, and their clocks are not reliable. A certificate
//! is therefore recognized as a host key of SSH is: by its fingerprint, without names, dates and issuers. The signature of
//! each handshake proves that the server has the key of the certificate. Data connections resume the session of the
//! control connection, which some servers require.

use std::io::{ErrorKind, Read, Write};
use std::net::{Shutdown, TcpStream};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use rustls::client::danger::{HandshakeSignatureValid, ServerCertVerified, ServerCertVerifier};
use rustls::crypto::{WebPkiSupportedAlgorithms, ring, verify_tls12_signature, verify_tls13_signature};
use rustls::pki_types::{CertificateDer, ServerName, UnixTime};
use rustls::version::{TLS12, TLS13};
use rustls::{
    CertificateError, ClientConfig, ClientConnection, DigitallySignedStruct, Error, SignatureScheme, StreamOwned,
};
use suppaftp::{FtpError, FtpResult, TlsConnector, TlsStream};

use crate::access::AccessFault;
use crate::certificate::CertificateFingerprint;

/// Wait for the end of a server that has received a file.
const END_LIMIT: Duration = Duration::from_secs(1);

/// Certificates that a connection accepts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum AcceptedCertificate {
    /// Each certificate, for a connection that only reads the fingerprint.
    Any,
    /// Only this one.
    Only(CertificateFingerprint),
}

/// Certificate and fault of a session's handshakes, because `suppaftp` passes on only error texts.
#[derive(Debug, Default)]
struct HandshakeRecord {
    presented: Option<CertificateFingerprint>,
    is_established: bool,
    fault: Option<AccessFault>,
}

/// Shared by the verifier, the connector and the connection.
type SharedRecord = Arc<Mutex<HandshakeRecord>>;

fn lock(record: &Mutex<HandshakeRecord>) -> MutexGuard<'_, HandshakeRecord> {
    // No code panics while it holds the lock.
    record.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Establishes TLS on a control connection and its data connections.
#[derive(Debug, Clone)]
pub(super) struct TlsSession {
    config: Arc<ClientConfig>,
    accepted: AcceptedCertificate,
    record: SharedRecord,
    timeout: Duration,
}

impl TlsSession {
    pub(super) fn new(accepted: AcceptedCertificate, timeout: Duration) -> Result<Self, AccessFault> {
        let record = SharedRecord::default();
        let provider = Arc::new(ring::default_provider());
        let algorithms = provider.signature_verification_algorithms;
        let verifier = CertificateVerifier { accepted, algorithms, record: Arc::clone(&record) };
        let builder = ClientConfig::builder_with_provider(provider).with_protocol_versions(&[&TLS13, &TLS12]);
        let builder = builder.map_err(|error| AccessFault::Handshake(error.to_string()))?;
        let config = builder.dangerous().with_custom_certificate_verifier(Arc::new(verifier)).with_no_client_auth();
        Ok(Self { config: Arc::new(config), accepted, record, timeout })
    }

    /// Certificate that the server has proved to own; `None` before the end of the first handshake.
    pub(super) fn proved(&self) -> Option<CertificateFingerprint> {
        let record = lock(&self.record);
        record.presented.filter(|_| record.is_established)
    }

    /// Fault of the last handshake.
    pub(super) fn take_fault(&self) -> Option<AccessFault> {
        lock(&self.record).fault.take()
    }

    fn handshake(&self, host: &str, socket: TcpStream) -> Result<TlsSocket, AccessFault> {
        let failed = |error: std::io::Error| self.fault(&error);
        // An accepted data connection has no limits yet.
        socket.set_read_timeout(Some(self.timeout)).map_err(failed)?;
        socket.set_write_timeout(Some(self.timeout)).map_err(failed)?;
        let name = match ServerName::try_from(host.to_owned()) {
            Ok(name) => name,
            // Such as an IPv6 number with a zone, which is no name for TLS.
            Err(_) => ServerName::from(socket.peer_addr().map_err(failed)?.ip()),
        };
        let connection = ClientConnection::new(Arc::clone(&self.config), name);
        let connection = connection.map_err(|error| AccessFault::Handshake(error.to_string()))?;
        let mut stream = StreamOwned::new(connection, socket);
        while stream.conn.is_handshaking() {
            stream.conn.complete_io(&mut stream.sock).map_err(failed)?;
        }
        lock(&self.record).is_established = true;
        Ok(TlsSocket { stream, is_upload: false })
    }

    fn fault(&self, error: &std::io::Error) -> AccessFault {
        match (self.accepted, lock(&self.record).presented) {
            (AcceptedCertificate::Only(expected), Some(found)) if expected != found => {
                AccessFault::OtherCertificate { expected, found }
            }
            _ if matches!(error.kind(), ErrorKind::TimedOut | ErrorKind::WouldBlock) => AccessFault::Timeout,
            _ => AccessFault::Handshake(error.to_string()),
        }
    }
}

impl TlsConnector for TlsSession {
    type Stream = TlsSocket;

    /// Completes the handshake, so that no command follows a rejected certificate.
    fn connect(&self, host: &str, socket: TcpStream) -> FtpResult<TlsSocket> {
        self.handshake(host, socket).map_err(|fault| {
            let text = fault.to_string();
            lock(&self.record).fault = Some(fault);
            FtpError::SecureError(text)
        })
    }
}

/// Compares fingerprints, and verifies signatures with the key of the certificate.
#[derive(Debug)]
struct CertificateVerifier {
    accepted: AcceptedCertificate,
    algorithms: WebPkiSupportedAlgorithms,
    record: SharedRecord,
}

impl ServerCertVerifier for CertificateVerifier {
    fn verify_server_cert(
        &self,
        end_entity: &CertificateDer<'_>,
        _: &[CertificateDer<'_>],
        _: &ServerName<'_>,
        _: &[u8],
        _: UnixTime,
    ) -> Result<ServerCertVerified, Error> {
        let found = CertificateFingerprint::of(end_entity);
        lock(&self.record).presented = Some(found);
        match self.accepted {
            AcceptedCertificate::Only(expected) if expected != found => {
                Err(CertificateError::ApplicationVerificationFailure.into())
            }
            _ => Ok(ServerCertVerified::assertion()),
        }
    }

    fn verify_tls12_signature(
        &self,
        message: &[u8],
        certificate: &CertificateDer<'_>,
        signature: &DigitallySignedStruct,
    ) -> Result<HandshakeSignatureValid, Error> {
        verify_tls12_signature(message, certificate, signature, &self.algorithms)
    }

    fn verify_tls13_signature(
        &self,
        message: &[u8],
        certificate: &CertificateDer<'_>,
        signature: &DigitallySignedStruct,
    ) -> Result<HandshakeSignatureValid, Error> {
        verify_tls13_signature(message, certificate, signature, &self.algorithms)
    }

    fn supported_verify_schemes(&self) -> Vec<SignatureScheme> {
        self.algorithms.supported_schemes()
    }
}

/// An encrypted connection.
#[derive(Debug)]
pub(super) struct TlsSocket {
    stream: StreamOwned<ClientConnection, TcpStream>,
    /// Whether bytes were written, and the reply of the server may be unread.
    is_upload: bool,
}

impl Read for TlsSocket {
    /// An end without the mark of TLS is an error: otherwise, an attacker could truncate a file.
    fn read(&mut self, buffer: &mut [u8]) -> std::io::Result<usize> {
        let read = self.stream.read(buffer);
        self.is_upload = false;
        read
    }
}

impl Write for TlsSocket {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        self.is_upload = true;
        self.stream.write(bytes)
    }

    fn flush(&mut self) -> std::io::Result<()> {
        self.is_upload = true;
        self.stream.flush()
    }
}

impl TlsStream for TlsSocket {
    type InnerStream = Self;

    fn tcp_stream(self) -> FtpResult<TcpStream> {
        self.get_ref().try_clone().map_err(FtpError::ConnectionError)
    }

    fn get_ref(&self) -> &TcpStream {
        self.stream.get_ref()
    }

    fn mut_ref(&mut self) -> &mut Self {
        self
    }
}

impl TlsSocket {
    /// Sends the mark of the end. After an upload, receives what the server has sent: tickets, with which the next data
    /// connection resumes the session. Unread bytes would also reset the connection before the server has read the file.
    fn end(&mut self) -> std::io::Result<()> {
        self.stream.conn.send_close_notify();
        self.stream.flush()?;
        if self.is_upload {
            self.stream.sock.shutdown(Shutdown::Write)?;
            self.stream.sock.set_read_timeout(Some(END_LIMIT))?;
            let mut rest = [0; 1024];
            while self.stream.read(&mut rest)? > 0 {}
        }
        Ok(())
    }
}

impl Drop for TlsSocket {
    /// Errors do not matter: the reply on the control connection states whether the transfer has succeeded.
    fn drop(&mut self) {
        let _ = self.end();
    }
}
