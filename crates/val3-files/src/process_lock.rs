//! Lock of a file against other processes.

use std::fs::{self, File, OpenOptions};

use camino::Utf8Path;

use crate::Unwritable;
use crate::temporary::lock;

/// A file that this process has locked. The system releases the lock when the value is dropped or the process ends.
#[derive(Debug)]
pub struct ProcessLock {
    _file: File,
}

impl ProcessLock {
    /// Locks the file at `path`, which is created if it does not exist, and remains. On a file system without locks,
    /// every process acquires it.
    ///
    /// # Errors
    /// If the file is locked ([`Unwritable::Busy`]), is not a regular file, or cannot be created.
    pub fn acquire(path: &Utf8Path) -> Result<Self, Unwritable> {
        if fs::symlink_metadata(path).is_ok_and(|found| !found.is_file()) {
            return Err(Unwritable::NotRegular);
        }
        let file = OpenOptions::new().read(true).write(true).create(true).truncate(false).open(path)?;
        lock(&file)?;
        Ok(Self { _file: file })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::folder;

    #[test]
    fn a_file_is_locked_once_until_the_lock_is_dropped() {
        let (_kept, folder) = folder();
        let path = folder.join("lock");
        let held = ProcessLock::acquire(&path).unwrap();
        assert_eq!(ProcessLock::acquire(&path).unwrap_err(), Unwritable::Busy);
        drop(held);
        ProcessLock::acquire(&path).unwrap();
        assert_eq!(ProcessLock::acquire(&folder).unwrap_err(), Unwritable::NotRegular);
    }
}
