//! Encrypted control connections: the password is sent only to a server that has the key of the accepted certificate.
//!
//! The certificates and keys were made for these tests, by `openssl req -x509 -newkey ec -pkeyopt ec_paramgen_curve:P-256`.

use std::io::{BufRead as _, BufReader, Write as _};
use std::net::{TcpListener, TcpStream};
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::Duration;

use rustls::crypto::ring::{default_provider, sign::any_ecdsa_type};
use rustls::pki_types::{CertificateDer, PrivatePkcs8KeyDer};
use rustls::server::{ClientHello, ResolvesServerCert};
use rustls::sign::CertifiedKey;
use rustls::version::{TLS12, TLS13};
use rustls::{ServerConfig, ServerConnection, StreamOwned, SupportedProtocolVersion};
use sha2::{Digest as _, Sha256};
use val3_controller::{
    AccessError, AccessFault, CertificateFingerprint, ConnectionSettings, FtpAddress, FtpFiles, FtpTimeouts, Password,
    ServerAddress,
};

use crate::bench::tree;
use crate::server::{Behaviour, Server};

const FIRST: &[u8] = include_bytes!("certificates/first.certificate.der");
const FIRST_KEY: &[u8] = include_bytes!("certificates/first.key.der");
const SECOND: &[u8] = include_bytes!("certificates/second.certificate.der");
const SECOND_KEY: &[u8] = include_bytes!("certificates/second.key.der");

/// A server that speaks FTP up to the login.
struct TlsServer {
    port: u16,
    commands: Arc<Mutex<Vec<String>>>,
}

/// A certificate with any key.
#[derive(Debug)]
struct Identity(Arc<CertifiedKey>);

impl ResolvesServerCert for Identity {
    fn resolve(&self, _: ClientHello<'_>) -> Option<Arc<CertifiedKey>> {
        Some(Arc::clone(&self.0))
    }
}

impl TlsServer {
    fn start(version: &'static SupportedProtocolVersion, certificate: &'static [u8], key: &'static [u8]) -> Self {
        let key = any_ecdsa_type(&PrivatePkcs8KeyDer::from(key).into()).unwrap();
        let identity = Identity(Arc::new(CertifiedKey::new(vec![CertificateDer::from(certificate)], key)));
        let builder = ServerConfig::builder_with_provider(Arc::new(default_provider()));
        let builder = builder.with_protocol_versions(&[version]).unwrap().with_no_client_auth();
        let config = Arc::new(builder.with_cert_resolver(Arc::new(identity)));
        let listener = TcpListener::bind("127.0.0.1:0").unwrap();
        let port = listener.local_addr().unwrap().port();
        let commands = Arc::new(Mutex::new(Vec::new()));
        let log = Arc::clone(&commands);
        thread::spawn(move || {
            for socket in listener.incoming().map(Result::unwrap) {
                // A client that rejects the certificate closes the connection.
                let _ = serve(socket, Arc::clone(&config), &log);
            }
        });
        Self { port, commands }
    }

    fn address(&self) -> FtpAddress {
        FtpAddress {
            is_encrypted: true,
            server: ServerAddress { user: "default".into(), host: "127.0.0.1".into(), port: self.port },
            base: String::new(),
        }
    }

    fn connect(&self, fingerprint: Option<CertificateFingerprint>) -> Result<FtpFiles, AccessError> {
        connect(self.address(), fingerprint)
    }

    fn commands(&self) -> String {
        self.commands.lock().unwrap().join(", ")
    }
}

fn serve(socket: TcpStream, config: Arc<ServerConfig>, log: &Mutex<Vec<String>>) -> std::io::Result<()> {
    (&socket).write_all(b"220 ready\r\n")?;
    let mut line = String::new();
    BufReader::new(socket.try_clone()?).read_line(&mut line)?;
    log.lock().unwrap().push(line.trim_end().to_owned());
    (&socket).write_all(b"234 start\r\n")?;
    let mut lines = BufReader::new(StreamOwned::new(ServerConnection::new(config).unwrap(), socket));
    loop {
        let mut line = String::new();
        if lines.read_line(&mut line)? == 0 {
            return Ok(());
        }
        log.lock().unwrap().push(line.trim_end().to_owned());
        let reply: &[u8] = match line.get(..4) {
            Some("USER") => b"331 password\r\n",
            Some("PASS") => b"230 welcome\r\n",
            Some("QUIT") => b"221 bye\r\n",
            Some("FEAT") => b"211 no features\r\n",
            _ => b"200 ok\r\n",
        };
        lines.get_mut().write_all(reply)?;
        lines.get_mut().flush()?;
    }
}

fn connect(address: FtpAddress, fingerprint: Option<CertificateFingerprint>) -> Result<FtpFiles, AccessError> {
    let settings = ConnectionSettings { fingerprint, is_active: false };
    FtpFiles::connect(address, Password::new("secret".to_owned()), settings, timeouts())
}

fn timeouts() -> FtpTimeouts {
    FtpTimeouts { connect: Duration::from_secs(10), transfer: Duration::from_secs(10) }
}

fn fingerprint(certificate: &[u8]) -> CertificateFingerprint {
    format!("{:x}", Sha256::digest(certificate)).parse().unwrap()
}

#[test]
fn a_login_follows_the_handshake_with_the_accepted_certificate() {
    for version in [&TLS12, &TLS13] {
        let server = TlsServer::start(version, FIRST, FIRST_KEY);
        drop(server.connect(Some(fingerprint(FIRST))).unwrap());
        assert_eq!(
            server.commands(),
            "AUTH TLS, PBSZ 0, PROT P, USER default, PASS secret, TYPE I, FEAT, QUIT",
            "{version:?}"
        );
    }
}

#[test]
fn an_unknown_certificate_is_reported_without_a_login() {
    for version in [&TLS12, &TLS13] {
        let server = TlsServer::start(version, FIRST, FIRST_KEY);
        let error = server.connect(None).unwrap_err();
        assert_eq!(error.reason, AccessFault::UnknownCertificate(fingerprint(FIRST)));
        assert_eq!(FtpFiles::fingerprint(&server.address(), timeouts()), Ok(fingerprint(FIRST)));
        let [once, twice] = [1, 2].map(|times| ["AUTH TLS, PBSZ 0, PROT P, QUIT"].repeat(times).join(", "));
        assert!([once, twice].contains(&server.commands()), "{}", server.commands());
    }
}

#[test]
fn another_certificate_is_rejected_before_the_login() {
    for version in [&TLS12, &TLS13] {
        let server = TlsServer::start(version, SECOND, SECOND_KEY);
        let error = server.connect(Some(fingerprint(FIRST))).unwrap_err();
        let [expected, found] = [FIRST, SECOND].map(fingerprint);
        assert_eq!(error.reason, AccessFault::OtherCertificate { expected, found });
        assert_eq!(server.commands(), "AUTH TLS");
    }
}

/// Everybody can copy a certificate, but not its key.
#[test]
fn a_copied_certificate_without_its_key_is_rejected() {
    for version in [&TLS12, &TLS13] {
        let server = TlsServer::start(version, FIRST, SECOND_KEY);
        for error in [
            server.connect(Some(fingerprint(FIRST))).unwrap_err(),
            FtpFiles::fingerprint(&server.address(), timeouts()).unwrap_err(),
        ] {
            let AccessFault::Handshake(reason) = error.reason else { panic!("{version:?}: {error}") };
            assert!(reason.contains("BadSignature"), "{version:?}: {reason}");
        }
        assert_eq!(server.commands(), "AUTH TLS, AUTH TLS");
    }
}

#[test]
fn without_tls_there_is_no_fallback_to_plain_text() {
    for reply in ["500 unknown command", "504 no TLS"] {
        let server = Server::start(tree(), Behaviour { auth_reply: reply, ..Behaviour::default() });
        let address = FtpAddress { is_encrypted: true, ..server.address() };
        for fingerprint in [None, Some(fingerprint(FIRST))] {
            let error = connect(address.clone(), fingerprint).unwrap_err();
            assert!(matches!(error.reason, AccessFault::NoTls { code: 500 | 504, .. }), "{error}");
        }
        assert!(server.state().log.is_empty());
    }
}
