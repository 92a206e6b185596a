//! Overwrites a file that cannot be replaced, because it has several links, or because its owner or attributes would be
//! lost.
//!
//! The old content is first stored in `.start.pgx.val3-old`, which is removed after the new content is complete. If the
//! process is killed in between, this backup remains, and further writes are rejected until the user has decided.

use std::fs::{self, File};
use std::io::{self, Seek as _};

use camino::Utf8Path;

use crate::Unwritable;
use crate::temporary::{Access, backup, create_new, sync_folder};

/// Overwrites `target` with the content of `new`.
pub(crate) fn overwrite(target: &Utf8Path, new: &mut File) -> Result<(), Unwritable> {
    let mut file = File::options().read(true).write(true).open(target)?;
    let backup = backup(target);
    let mut old = match create_new(&backup, Access::Owner) {
        Err(error) if error.kind() == io::ErrorKind::AlreadyExists => return Err(Unwritable::Interrupted(backup)),
        created => created?,
    };
    let saved = copy(&mut file, &mut old).and_then(|_| sync_folder(target));
    if let Err(error) = saved {
        fs::remove_file(&backup)?;
        return Err(error.into());
    }
    if let Err(error) = copy(new, &mut file) {
        // The disk may be full. The old content still fits, because it needs no more space than before.
        copy(&mut old, &mut file)?;
        fs::remove_file(&backup)?;
        return Err(error.into());
    }
    fs::remove_file(&backup)?;
    Ok(sync_folder(target)?)
}

/// Copies the content of `from` to `to`, and syncs it to the disk.
fn copy(from: &mut File, to: &mut File) -> io::Result<()> {
    from.rewind()?;
    to.rewind()?;
    let length = io::copy(from, to)?;
    to.set_len(length)?;
    to.sync_all()
}
