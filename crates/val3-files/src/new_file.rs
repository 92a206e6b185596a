//! Atomic creation and replacement of files.

use std::fs;
use std::io::{self, Write};

use camino::{Utf8Path, Utf8PathBuf};

use crate::temporary::{Access, Temporary};
use crate::{Unwritable, copied_metadata, in_place};

/// Replaces the content of a file atomically, or creates the file.
///
/// # Errors
/// If the file cannot be written. Its content is then unchanged.
pub fn replace(path: &Utf8Path, bytes: &[u8]) -> Result<(), Unwritable> {
    let mut file = NewFile::create(path)?;
    file.write_all(bytes)?;
    file.commit()
}

/// A file that is being written. `commit` moves it to its name and replaces an existing file. Dropping it without
/// `commit` changes nothing.
#[derive(Debug)]
pub struct NewFile {
    /// Path with resolved symbolic links, so that a link is not replaced by a file.
    target: Utf8PathBuf,
    temporary: Temporary,
}

impl NewFile {
    /// Starts writing the file.
    ///
    /// # Errors
    /// If the folder does not exist or is not writable, if another process writes the file, or if the path is not a
    /// regular file.
    pub fn create(path: &Utf8Path) -> Result<Self, Unwritable> {
        let target = path.canonicalize_utf8().unwrap_or_else(|_| path.to_owned());
        let existing = fs::metadata(&target).ok();
        if existing.as_ref().is_some_and(|found| !found.is_file()) || target.file_name().is_none() {
            return Err(Unwritable::NotRegular);
        }
        let access = if existing.is_some() { Access::Owner } else { Access::Usual };
        Ok(Self { temporary: Temporary::create(&target, access)?, target })
    }

    /// Replaces the file. The owner, mode, extended attributes and hard links are kept.
    ///
    /// # Errors
    /// If the file cannot be replaced. Its content is then unchanged, unless the error is an earlier interrupted write.
    pub fn commit(mut self) -> Result<(), Unwritable> {
        self.temporary.file.sync_all()?;
        match fs::metadata(&self.target) {
            Ok(found) if !found.is_file() => Err(Unwritable::NotRegular),
            Ok(found) if found.permissions().readonly() => Err(Unwritable::ReadOnly),
            Ok(found) if !copied_metadata::copy(&self.target, &found, &self.temporary.file) => {
                in_place::overwrite(&self.target, &mut self.temporary.file)
            }
            Ok(_) => Ok(self.temporary.rename(&self.target)?),
            Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(self.temporary.rename(&self.target)?),
            Err(error) => Err(error.into()),
        }
    }
}

impl Write for NewFile {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.temporary.file.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.temporary.file.flush()
    }
}

#[cfg(test)]
mod tests;
