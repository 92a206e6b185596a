//! A controller's FTP server.
//!
//! CS9 lists by `MLSD`, CS8 by `LIST` in Unix or DOS form; what each controller supports is inferred from public tools.
//! Sizes, dates and `REST` are not used. One connection serves all commands, because small systems allow few.

mod connection;
mod listing;

use std::io::Read as _;
use std::io::Write as _;
use std::time::Duration;

use suppaftp::{FtpError, FtpStream};

use crate::access::{AccessError, AccessFault, ControllerFiles, ListedEntry};
use crate::address::FtpAddress;
use crate::path::ControllerPath;
use connection::{connect, fault};
use listing::{LISTING_LIMIT, ListingCommand};

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

/// Files behind an FTP connection.
pub struct FtpFiles {
    address: FtpAddress,
    password: Password,
    timeouts: FtpTimeouts,
    place: String,
    /// `None` after an error that leaves replies unread.
    connection: Option<FtpStream>,
    listing: ListingCommand,
}

impl std::fmt::Debug for FtpFiles {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("FtpFiles").field("address", &self.address).finish_non_exhaustive()
    }
}

impl FtpFiles {
    /// Connects and logs in.
    ///
    /// # Errors
    /// If the server cannot be reached or rejects the login.
    pub fn connect(address: FtpAddress, password: Password, timeouts: FtpTimeouts) -> Result<Self, AccessError> {
        let place = address.place();
        let mut files = Self { address, password, timeouts, place, connection: None, listing: ListingCommand::List };
        files.reconnect()?;
        Ok(files)
    }

    /// Path as the server expects it.
    fn remote(&self, path: &ControllerPath) -> String {
        format!("{}/{}", self.address.base, path.as_str())
    }

    /// Executes commands. After an error of the connection, no further command is sent.
    fn execute<T>(
        &mut self,
        step: impl FnOnce() -> String,
        commands: impl FnOnce(&mut FtpStream) -> Result<T, AccessFault>,
    ) -> Result<T, AccessError> {
        let result = match &mut self.connection {
            None => Err(AccessFault::Connection("it was lost before".to_owned())),
            Some(connection) => commands(connection),
        };
        result.map_err(|reason| {
            if matches!(
                reason,
                AccessFault::Connection(_) | AccessFault::Timeout | AccessFault::Rejected { code: 421, .. }
            ) {
                self.connection = None;
            }
            AccessError { step: step(), place: self.place.clone(), reason }
        })
    }

    /// Executes one command with one path.
    fn on_path(
        &mut self,
        verb: &str,
        path: &ControllerPath,
        command: impl FnOnce(&mut FtpStream, &str) -> Result<(), FtpError>,
    ) -> Result<(), AccessError> {
        let remote = self.remote(path);
        self.execute(|| format!("{verb} `{path}`"), |ftp| command(ftp, &remote).map_err(fault))
    }
}

/// Ends the session, because small systems allow few. Errors do not matter, because no command is pending.
impl Drop for FtpFiles {
    fn drop(&mut self) {
        if let Some(mut connection) = self.connection.take() {
            let _ = connection.get_ref().set_read_timeout(Some(Duration::from_secs(1)));
            let _ = connection.quit();
        }
    }
}

impl ControllerFiles for FtpFiles {
    fn place(&self) -> &str {
        &self.place
    }

    fn list(&mut self, folder: &ControllerPath) -> Result<Vec<ListedEntry>, AccessError> {
        let remote = self.remote(folder);
        let mut command = self.listing;
        let entries =
            self.execute(|| format!("list `{folder}`"), |ftp| listing::list(ftp, folder, &remote, &mut command));
        self.listing = command;
        entries
    }

    fn read(&mut self, file: &ControllerPath, limit: u64) -> Result<Vec<u8>, AccessError> {
        let remote = self.remote(file);
        self.execute(|| format!("read `{file}`"), |ftp| read(ftp, &remote, limit))
    }

    fn write(&mut self, file: &ControllerPath, bytes: &[u8]) -> Result<(), AccessError> {
        self.on_path("write", file, |ftp, remote| {
            let mut stream = ftp.put_with_stream(remote)?;
            let written = stream.write_all(bytes).and_then(|()| stream.flush());
            // The reply contains the reason if the server has closed the transfer.
            stream.finish()?;
            written.map_err(FtpError::ConnectionError)
        })
    }

    fn rename(&mut self, from: &ControllerPath, to: &ControllerPath) -> Result<(), AccessError> {
        let [old, new] = [self.remote(from), self.remote(to)];
        self.execute(|| format!("rename `{from}` to `{}`", to.name()), |ftp| ftp.rename(&old, &new).map_err(fault))
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
        self.connection = None;
        let (connection, listing) = connect(&self.address, &self.password.0, self.timeouts).map_err(|failure| {
            AccessError { step: failure.step.to_owned(), place: self.place.clone(), reason: failure.reason }
        })?;
        (self.connection, self.listing) = (Some(connection), listing);
        Ok(())
    }
}

/// Receives a file up to a limit.
fn read(ftp: &mut FtpStream, remote: &str, limit: u64) -> Result<Vec<u8>, AccessFault> {
    let mut stream = ftp.retr_as_stream(remote).map_err(fault)?;
    let mut bytes = Vec::new();
    let received = (&mut stream).take(limit.saturating_add(1)).read_to_end(&mut bytes);
    if bytes.len() as u64 > limit {
        // The reply to the interrupted transfer has no meaning.
        let _ = stream.finish();
        return Err(AccessFault::TooLarge(limit));
    }
    // A transfer that ends early has no reply of success, even if the connection was closed properly.
    stream.finish().map_err(fault)?;
    received.map_err(|error| fault(FtpError::ConnectionError(error)))?;
    Ok(bytes)
}

/// Receives the lines of a listing command.
fn read_lines(ftp: &mut FtpStream, command: &str) -> Result<Vec<String>, AccessFault> {
    use suppaftp::Status;
    let opened = [Status::AboutToSend, Status::AlreadyOpen];
    let (_, mut stream) = ftp.custom_data_command(command, &opened).map_err(fault)?;
    let mut bytes = Vec::new();
    let received = (&mut stream).take(LISTING_LIMIT + 1).read_to_end(&mut bytes);
    if bytes.len() as u64 > LISTING_LIMIT {
        let _ = stream.finish();
        return Err(AccessFault::TooLarge(LISTING_LIMIT));
    }
    stream.finish().map_err(fault)?;
    received.map_err(|error| fault(FtpError::ConnectionError(error)))?;
    let text = String::from_utf8_lossy(&bytes);
    Ok(text.lines().map(str::to_owned).filter(|line| !line.is_empty()).collect())
}
