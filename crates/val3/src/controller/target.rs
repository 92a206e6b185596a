//! A controller at an address: the settings of its connections, and the trust in its certificate.

use val3_controller::{
    CertificateFingerprint, ConnectionSettings, ControllerAddress, ControllerError, ControllerFiles, FolderFiles,
    FtpAddress, FtpFiles, FtpTimeouts, ProjectState,
};

use super::password;
use super::question::{can_ask, is_confirmed};
use crate::args::ConnectionArgs;
use crate::user_error::UserError;

/// Address of a controller with the settings of its connections.
#[derive(Debug)]
pub(crate) struct ControllerTarget {
    pub(crate) address: ControllerAddress,
    /// Settings that a pull remembers.
    pub(crate) settings: ConnectionSettings,
}

impl ControllerTarget {
    /// Combines the options with the settings that a project remembers of the same server.
    ///
    /// # Errors
    /// An option has no meaning for the address.
    pub(crate) fn new(
        address: ControllerAddress,
        args: &ConnectionArgs,
        state: Option<&ProjectState>,
    ) -> Result<Self, UserError> {
        match &address {
            ControllerAddress::Folder(_) => check_no_option(args)?,
            ControllerAddress::Ftp(ftp) if args.fingerprint.is_some() && !ftp.is_encrypted => {
                return Err(UserError::new("--fingerprint requires an address `ftps://`")
                    .with_help("without TLS, a controller has no certificate"));
            }
            ControllerAddress::Ftp(_) => {}
        }
        let known = state.map(|state| state.connection(&address)).unwrap_or_default();
        let settings = ConnectionSettings {
            fingerprint: args.fingerprint.or(known.fingerprint),
            is_active: args.active || known.is_active && !args.passive,
        };
        Ok(Self { address, settings })
    }

    /// Opens the files. For a server, the certificate is accepted first, then the password is read.
    ///
    /// # Errors
    /// The user or the remembered fingerprint rejects the certificate, or the controller cannot be reached.
    pub(crate) fn connect(&mut self) -> Result<Box<dyn ControllerFiles>, UserError> {
        Ok(match &self.address {
            ControllerAddress::Folder(folder) => Box::new(FolderFiles::open(folder).map_err(ControllerError::from)?),
            ControllerAddress::Ftp(ftp) => {
                // Without a terminal, the connection ends with an error that names the fingerprint.
                if ftp.is_encrypted && self.settings.fingerprint.is_none() && can_ask() {
                    self.settings.fingerprint = Some(accepted_fingerprint(ftp)?);
                }
                let password = password::read(&ftp.server)?;
                let files = FtpFiles::connect(ftp.clone(), password, self.settings, FtpTimeouts::default());
                Box::new(files.map_err(ControllerError::from)?)
            }
        })
    }
}

/// Checks that no option of connections is used, for a command without one.
///
/// # Errors
/// An option is used.
pub(crate) fn check_no_option(args: &ConnectionArgs) -> Result<(), UserError> {
    match args.used() {
        None => Ok(()),
        Some(option) => Err(UserError::new(format!("{option} requires the address of a server"))
            .with_help("omit it, or write `ftp://PROFILE@HOST` or `ftps://PROFILE@HOST`")),
    }
}

/// Fingerprint of a certificate that the user accepts.
fn accepted_fingerprint(address: &FtpAddress) -> Result<CertificateFingerprint, UserError> {
    let found = FtpFiles::fingerprint(address, FtpTimeouts::default()).map_err(ControllerError::from)?;
    let host = &address.server.host;
    let question = format!(
        "The certificate of {host} is not known. Its fingerprint is {found}. Compare it with the certificate on the controller. \
         Is it the same?"
    );
    if is_confirmed(&question)? {
        return Ok(found);
    }
    Err(UserError::new(format!("the certificate of {host} was not accepted"))
        .with_help("no password was sent; compare the fingerprint with the certificate on the controller"))
}
