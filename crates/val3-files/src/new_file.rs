//! Files that appear as a whole, in place of others.

use std::fs;
use std::io::{self, Write};

use camino::{Utf8Path, Utf8PathBuf};

use crate::temporary::{Access, Temporary};
use crate::{Unwritable, copied_metadata, in_place};

/// Replaces the content of a file as a whole, or creates it.
///
/// # Errors
/// The file cannot be written. It has its old content then.
pub fn replace(path: &Utf8Path, bytes: &[u8]) -> Result<(), Unwritable> {
    let mut file = NewFile::create(path)?;
    file.write_all(bytes)?;
    file.commit()
}

/// A file that is being written. It appears under its name, in place of another one, when it is committed. If it is
/// dropped before, nothing changes.
#[derive(Debug)]
pub struct NewFile {
    /// The path with links resolved, so that a link stays one.
    target: Utf8PathBuf,
    temporary: Temporary,
}

impl NewFile {
    /// Begins the file.
    ///
    /// # Errors
    /// The folder does not exist or cannot be written, another run writes the file, or the path is not that of a
    /// file.
    pub fn create(path: &Utf8Path) -> Result<Self, Unwritable> {
        let target = path.canonicalize_utf8().unwrap_or_else(|_| path.to_owned());
        let existing = fs::metadata(&target).ok();
        if existing.as_ref().is_some_and(|found| !found.is_file()) || target.file_name().is_none() {
            return Err(Unwritable::NotRegular);
        }
        let access = if existing.is_some() { Access::Owner } else { Access::Usual };
        Ok(Self { temporary: Temporary::create(&target, access)?, target })
    }

    /// Replaces the file. Owner, mode, extended attributes and hard links of a file that existed are kept.
    ///
    /// # Errors
    /// The file cannot be replaced. It has its old content then, unless the reason is that a write was interrupted.
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
