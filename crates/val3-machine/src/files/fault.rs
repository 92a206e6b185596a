//! Faults of paths, libraries and media.

use std::io;

/// The faults that a program can meet, with the number that 6.6 gives them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[repr(u16)]
pub enum FileFault {
    /// The identifier holds no library.
    NoLibrary = 10,
    /// Faulty data or programs, a damaged archive, or a wrong password.
    CannotLoad = 12,
    /// The root of the path names no medium.
    BadRoot = 20,
    /// The path cannot be followed, or would leave its medium.
    BadPath = 21,
    /// The last part of the path is no possible name.
    BadName = 22,
    /// An archive that is not encrypted, or not in the classic way.
    NotEncrypted = 23,
    /// The medium failed in another way.
    Medium = 30,
    /// The path to save to holds a library.
    LibraryThere = 31,
    /// The device is not there.
    NoDevice = 32,
    /// The device took too long.
    TimedOut = 34,
    /// The device takes no writes.
    WriteProtected = 35,
    /// No room is left.
    DiskFull = 38,
    /// No such file.
    NotFound = 39,
    /// The file takes no writes.
    ReadOnly = 40,
    /// A server turned the connection down.
    Refused = 41,
}

impl FileFault {
    /// The number that the library instructions return.
    #[must_use]
    pub fn code(self) -> u16 {
        self as u16
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
