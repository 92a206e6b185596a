//! Writes without a temporary file.

use std::fs::{self, File};
use std::io::Write as _;

use camino::Utf8Path;

use crate::Unwritable;

/// Writes a file, and syncs it to the disk. If the process is killed, the file may have a part of the content: this is
/// for callers who write to names of their own and rename the file.
///
/// # Errors
/// If the path is not a regular file, or cannot be written.
pub fn write_directly(path: &Utf8Path, bytes: &[u8]) -> Result<(), Unwritable> {
    if fs::metadata(path).is_ok_and(|found| !found.is_file()) {
        return Err(Unwritable::NotRegular);
    }
    let mut file = File::create(path)?;
    file.write_all(bytes)?;
    Ok(file.sync_all()?)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::folder;

    #[test]
    fn a_file_has_its_name_from_the_start() {
        let (_kept, folder) = folder();
        let path = folder.join("a.pgx");
        write_directly(&path, b"long").unwrap();
        write_directly(&path, b"new").unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"new");
        assert_eq!(write_directly(&folder, b"new"), Err(Unwritable::NotRegular));
    }
}
