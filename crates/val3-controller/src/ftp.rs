//! A controller's FTP server.
//!
//! CS9 lists by `MLSD`, CS8 by `LIST` in Unix or DOS form; what each controller supports is inferred from public tools.
//! Sizes, dates and `REST` are not used. One connection serves all commands, because small systems allow few.

mod connection;
mod listing;
mod tls;
mod transfer;

use std::time::Duration;

use suppaftp::FtpError;

use crate::access::{AccessError, AccessFault, ControllerFiles, ListedEntry};
use crate::address::FtpAddress;
use crate::certificate::CertificateFingerprint;
use crate::connection_settings::{ConnectionSettings, FtpTimeouts};
use crate::path::ControllerPath;
use connection::{ConnectFailure, Connection, FtpClient, connect, fault, presented_certificate};
use listing::ListingCommand;

/// Password that no message shows.
#[derive(Clone, PartialEq, Eq)]
pub struct Password(String);

impl Password {
    /// Wraps a password.
    #[must_use]
    pub fn new(text: String) -> Self {
        Self(text)
    }

    /// The password, for a login.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.0
    }
}

impl std::fmt::Debug for Password {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("Password")
    }
}

/// Controller files by FTP.
pub struct FtpFiles {
    address: FtpAddress,
    password: Password,
    settings: ConnectionSettings,
    timeouts: FtpTimeouts,
    place: String,
    /// `None` after an error after which unread replies may remain.
    connection: Option<Connection>,
    listing: ListingCommand,
}

impl std::fmt::Debug for FtpFiles {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("FtpFiles").field("address", &self.address).finish_non_exhaustive()
    }
}

impl FtpFiles {
    /// Connects and logs in. The password is sent after the server has proved that it has the accepted certificate, if
    /// the address requires encryption.
    ///
    /// # Errors
    /// If the server cannot be reached, has not the accepted certificate, or rejects the login.
    pub fn connect(
        address: FtpAddress,
        password: Password,
        settings: ConnectionSettings,
        timeouts: FtpTimeouts,
    ) -> Result<Self, AccessError> {
        let (place, listing) = (address.server.place(), ListingCommand::List);
        let mut files = Self { address, password, settings, timeouts, place, connection: None, listing };
        files.reconnect()?;
        Ok(files)
    }

    /// Returns the fingerprint of a server's certificate, without a login. The server has proved that it has the key of
    /// the certificate.
    ///
    /// # Errors
    /// If the server cannot be reached or does not offer TLS.
    pub fn fingerprint(address: &FtpAddress, timeouts: FtpTimeouts) -> Result<CertificateFingerprint, AccessError> {
        presented_certificate(address, timeouts).map_err(|failure| access_error(failure, &address.server.place()))
    }

    /// Path as the server expects it.
    fn remote(&self, path: &ControllerPath) -> String {
        format!("{}/{}", self.address.base, path.as_str())
    }

    /// Executes commands. After an error of the connection, no further command is sent. After an interrupted transfer,
    /// the next command is sent on a new connection: servers send one or two replies, at any time.
    fn execute<T>(
        &mut self,
        step: impl FnOnce() -> String,
        commands: impl FnOnce(&mut Connection) -> Result<T, AccessFault>,
    ) -> Result<T, AccessError> {
        let result = match &mut self.connection {
            None => Err(AccessFault::Connection("it was lost before".to_owned())),
            Some(connection) => commands(connection),
        };
        let error = match result {
            Ok(result) => return Ok(result),
            Err(reason) => AccessError { step: step(), place: self.place.clone(), reason },
        };
        if error.ends_connection() {
            self.connection = None;
        } else if error.interrupts_transfer() {
            self.reconnect()?;
        }
        Err(error)
    }

    /// Executes commands that only read. If the server has closed the connection, for example because it was idle during
    /// a question or a check, they are repeated once on a new connection.
    fn execute_reading<T>(
        &mut self,
        step: impl Fn() -> String,
        mut commands: impl FnMut(&mut Connection, &mut ListingCommand) -> Result<T, AccessFault>,
    ) -> Result<T, AccessError> {
        let mut listing = self.listing;
        let first = self.execute(&step, |connection| commands(connection, &mut listing));
        let result = match first {
            Err(error) if error.is_closed() => {
                self.reconnect()?;
                listing = self.listing;
                self.execute(step, |connection| commands(connection, &mut listing))
            }
            first => first,
        };
        self.listing = listing;
        result
    }

    /// Ends the session, if there is one. Errors do not matter, because no further command is sent.
    fn quit(&mut self) {
        if let Some(mut connection) = self.connection.take() {
            let _ = connection.client.get_ref().set_read_timeout(Some(Duration::from_secs(1)));
            let _ = connection.client.quit();
        }
    }

    /// Executes one command with one path.
    fn on_path(
        &mut self,
        verb: &str,
        path: &ControllerPath,
        command: impl FnOnce(&mut FtpClient, &str) -> Result<(), FtpError>,
    ) -> Result<(), AccessError> {
        let remote = self.remote(path);
        self.execute(
            || format!("{verb} `{path}`"),
            |connection| command(&mut connection.client, &remote).map_err(fault),
        )
    }
}

/// Ends the session, because small systems allow few.
impl Drop for FtpFiles {
    fn drop(&mut self) {
        self.quit();
    }
}

impl ControllerFiles for FtpFiles {
    fn place(&self) -> &str {
        &self.place
    }

    fn list(&mut self, folder: &ControllerPath) -> Result<Vec<ListedEntry>, AccessError> {
        let remote = self.remote(folder);
        self.execute_reading(
            || format!("list `{folder}`"),
            |connection, command| listing::list(connection, folder, &remote, command),
        )
    }

    fn read(&mut self, file: &ControllerPath, limit: u64) -> Result<Vec<u8>, AccessError> {
        let remote = self.remote(file);
        self.execute_reading(|| format!("read `{file}`"), |connection, _| transfer::read(connection, &remote, limit))
    }

    fn write(&mut self, file: &ControllerPath, bytes: &[u8]) -> Result<(), AccessError> {
        let remote = self.remote(file);
        self.execute(|| format!("write `{file}`"), |connection| transfer::write(connection, &remote, bytes))
    }

    fn rename(&mut self, from: &ControllerPath, to: &ControllerPath) -> Result<(), AccessError> {
        let [old, new] = [self.remote(from), self.remote(to)];
        self.execute(
            || format!("rename `{from}` to `{}`", to.name()),
            |connection| connection.client.rename(&old, &new).map_err(fault),
        )
    }

    fn remove(&mut self, file: &ControllerPath) -> Result<(), AccessError> {
        self.on_path("remove", file, |ftp, remote| ftp.rm(remote))
    }

    fn make_folder(&mut self, folder: &ControllerPath) -> Result<(), AccessError> {
        self.on_path("create the folder", folder, |ftp, remote| ftp.mkdir(remote))
    }

    fn remove_folder(&mut self, folder: &ControllerPath) -> Result<(), AccessError> {
        self.on_path("remove the folder", folder, |ftp, remote| ftp.rmdir(remote))
    }

    fn reconnect(&mut self) -> Result<(), AccessError> {
        self.quit();
        let connected = connect(&self.address, &self.password.0, self.settings, self.timeouts);
        let mut connection = connected.map_err(|failure| access_error(failure, &self.place))?;
        let listing = ListingCommand::of_server(&mut connection.client);
        self.listing = listing.map_err(|reason| {
            let step = "query the features";
            access_error(ConnectFailure { step, reason }, &self.place)
        })?;
        self.connection = Some(connection);
        Ok(())
    }
}

fn access_error(ConnectFailure { step, reason }: ConnectFailure, place: &str) -> AccessError {
    AccessError { step: step.to_owned(), place: place.to_owned(), reason }
}
