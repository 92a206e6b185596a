//! Codes returned by `libLoad`, `libSave` and `libDelete` (6.6). These instructions never raise a run-time error.

/// A return code.
#[derive(Debug, PartialEq, Eq)]
pub struct LibraryError {
    /// Code.
    pub number: u16,
    /// Cause, in a few words.
    pub short: &'static str,
    /// Explanation and remedy.
    pub long: &'static str,
}

const fn row(number: u16, short: &'static str, long: &'static str) -> LibraryError {
    LibraryError { number, short, long }
}

/// The library was loaded, saved or deleted.
pub const DONE: u16 = 0;

/// No library is loaded under the identifier.
pub const NO_LIBRARY: u16 = 10;

/// The library was loaded, but does not match its interface.
pub const INTERFACE_DIFFERS: u16 = 11;

/// The library cannot be loaded; the event log contains the reason.
pub const CANNOT_LOAD: u16 = 12;

/// Another task is executing the library.
pub const IN_USE: u16 = 13;

/// A task that the library has created is still running.
pub const HAS_TASKS: u16 = 14;

/// All codes, ascending. Codes from 30 on mean that the file could not be read or written.
#[rustfmt::skip]
pub static LIBRARY_ERRORS: [LibraryError; 29] = [
    row(0, "no error", "The library was loaded, saved or deleted."),
    row(10, "identifier without library", "No libLoad has put a library under this identifier. Load one before."),
    row(11, "loaded, interface differs", "The library is loaded but lacks public data or programs that the \
        identifier promises; their use raises run-time error 80. Ask libExist or isDefined before, or adapt the \
        library."),
    row(12, "library cannot be loaded", "The library holds faulty data or programs, or the password of an \
        encrypted library is wrong. The event log names the fault."),
    row(13, "library in use by a task", "The library under the identifier cannot be replaced while another task \
        uses it, or a program has some of its data by reference."),
    row(14, "library has a running task", "A task that a program of the library created still runs. End it before \
        another library is loaded in its place."),
    row(20, "bad root in the path", "The part before :// names no medium: Disk, USB0 or a connection defined on \
        the controller."),
    row(21, "bad path", "The folder of the path does not exist or cannot be reached."),
    row(22, "bad file name", "The last part of the path is no possible name of a library."),
    row(23, "library not encrypted", "An encrypted library was wanted, but it is not encrypted, or not in the way \
        that the controller reads."),
    row(30, "file cannot be read or written", "The medium failed in a way that has no code of its own."),
    row(31, "a library is there already", "The path to save to holds a library. Remove it with libDelete before."),
    row(32, "device not found", "The device is not plugged in, or not recognised."),
    row(33, "device fault", "The device reports a fault. Try another one."),
    row(34, "device does not answer", "The device took too long to answer. Try again, or another one."),
    row(35, "device write-protected", "Remove the write protection of the device."),
    row(36, "no disk in the device", "Insert a disk."),
    row(37, "disk not formatted", "Format the disk for the controller."),
    row(38, "disk full", "Free some space on the disk."),
    row(39, "file not found", "There is no such library. Check path and spelling."),
    row(40, "file is read-only", "The file may not be changed."),
    row(41, "connection refused", "The server refuses the connection. Check that it runs and lets the controller \
        in."),
    row(42, "FTP server does not answer", "Check cable, address and server."),
    row(43, "FTP fault in the controller", "The network part of the controller failed. Restart it if this stays so."),
    row(44, "bad FTP parameter", "A parameter of the FTP connection is wrong. Check its configuration."),
    row(45, "FTP access denied", "The FTP user may not reach this file."),
    row(46, "FTP disk full", "Free some space on the disk of the server."),
    row(47, "bad FTP user", "The server does not know the user, or the password is wrong."),
    row(48, "no such FTP connection", "The connection that the root of the path names is not defined on the \
        controller."),
];

/// Codes that `libLoad` can return. Code 10 is excluded because it belongs to calls on a loaded library, and codes such
/// as 31 because they belong to writing.
pub fn of_load() -> impl Iterator<Item = &'static LibraryError> {
    LIBRARY_ERRORS.iter().filter(|row| !NEVER_BY_LOAD.contains(&row.number))
}

/// Codes of instructions that require a loaded library or write to the medium, and therefore not of `libLoad`.
const NEVER_BY_LOAD: [u16; 6] = [NO_LIBRARY, 31, 35, 38, 40, 46];

/// Finds a return code. A code above 30 that is not listed is treated as 30, a fault of the medium.
#[must_use]
pub fn find(number: u16) -> Option<&'static LibraryError> {
    let row = LIBRARY_ERRORS.iter().find(|row| row.number == number);
    if number > UNNAMED_FAULT { row.or_else(|| find(UNNAMED_FAULT)) } else { row }
}

const UNNAMED_FAULT: u16 = 30;

#[cfg(test)]
mod tests {
    use super::{LIBRARY_ERRORS, find, of_load};

    #[test]
    fn loading_writes_nothing() {
        let codes: Vec<u16> = of_load().map(|row| row.number).collect();
        let expected = [0, 11, 12, 13, 14, 20, 21, 22, 23, 30, 32, 33, 34, 36, 37, 39, 41, 42, 43, 44, 45, 47, 48];
        assert_eq!(codes, expected);
    }

    #[test]
    fn every_code_of_the_manual_is_there() {
        assert!(LIBRARY_ERRORS.iter().map(|row| row.number).is_sorted());
        let codes = [0, 10, 11, 12, 13, 14, 20, 21, 22, 23].into_iter().chain(30..=48);
        for code in codes {
            assert!(find(code).is_some_and(|row| !row.long.is_empty()), "{code}");
        }
        assert_eq!(find(77), find(30));
        assert_eq!(find(15), None);
    }
}
