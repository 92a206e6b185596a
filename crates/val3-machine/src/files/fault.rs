//! Faults of paths, libraries and media.

use std::io;

use val3_data::UnwritableValue;

/// Faults that a program can receive, with the number of 6.6.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[repr(u16)]
pub enum FileFault {
    /// No library is loaded under the identifier.
    NoLibrary = 10,
    /// Faulty data or programs, a damaged archive, or a wrong password.
    CannotLoad = 12,
    /// The root of the path names no medium.
    BadRoot = 20,
    /// The path cannot be resolved, or would leave its medium.
    BadPath = 21,
    /// The last part of the path is no valid name.
    BadName = 22,
    /// The archive is not encrypted, or not with the classic encryption.
    NotEncrypted = 23,
    /// The medium failed in another way.
    Medium = 30,
    /// A library exists at the path to save to.
    LibraryThere = 31,
    /// The device does not exist.
    NoDevice = 32,
    /// The device has exceeded the timeout.
    TimedOut = 34,
    /// The device is write-protected.
    WriteProtected = 35,
    /// The medium is full.
    DiskFull = 38,
    /// No such file.
    NotFound = 39,
    /// The file is read-only.
    ReadOnly = 40,
    /// A server has rejected the connection.
    Refused = 41,
    /// A value of the data cannot be contained in a file.
    Unwritable,
}

impl FileFault {
    /// The number that the library instructions return.
    #[must_use]
    pub fn code(self) -> u16 {
        match self {
            Self::Unwritable => Self::Medium as u16,
            fault => fault as u16,
        }
    }
}

impl From<UnwritableValue> for FileFault {
    fn from(_: UnwritableValue) -> Self {
        Self::Unwritable
    }
}

impl From<io::Error> for FileFault {
    fn from(error: io::Error) -> Self {
        Self::from(&error)
    }
}

impl From<&io::Error> for FileFault {
    fn from(error: &io::Error) -> Self {
        use io::ErrorKind as Kind;
        match error.kind() {
            Kind::StorageFull | Kind::QuotaExceeded | Kind::FileTooLarge => Self::DiskFull,
            Kind::ReadOnlyFilesystem => Self::WriteProtected,
            Kind::PermissionDenied => Self::ReadOnly,
            Kind::NotFound => Self::NotFound,
            Kind::NotADirectory | Kind::IsADirectory => Self::BadPath,
            Kind::InvalidFilename | Kind::InvalidInput => Self::BadName,
            Kind::TimedOut => Self::TimedOut,
            Kind::ConnectionRefused => Self::Refused,
            Kind::HostUnreachable | Kind::NetworkUnreachable => Self::NoDevice,
            _ => Self::Medium,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_fault_is_a_row_of_the_manual() {
        use FileFault::*;
        let all = [
            NoLibrary,
            CannotLoad,
            BadRoot,
            BadPath,
            BadName,
            NotEncrypted,
            Medium,
            LibraryThere,
            NoDevice,
            TimedOut,
            WriteProtected,
            DiskFull,
            Unwritable,
            NotFound,
            ReadOnly,
            Refused,
        ];
        for fault in all {
            let row = val3_lang::library_errors::find(fault.code());
            assert_eq!(row.map(|row| row.number), Some(fault.code()), "{fault:?}");
        }
    }

    #[test]
    fn system_errors_have_their_number() {
        let fault = |kind| FileFault::from(io::Error::from(kind)).code();
        assert_eq!(fault(io::ErrorKind::StorageFull), 38);
        assert_eq!(fault(io::ErrorKind::ReadOnlyFilesystem), 35);
        assert_eq!(fault(io::ErrorKind::PermissionDenied), 40);
        assert_eq!(fault(io::ErrorKind::NotFound), 39);
        assert_eq!(fault(io::ErrorKind::BrokenPipe), 30);
    }
}
