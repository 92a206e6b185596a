//! Owner, mode and extended attributes of a replaced file.

use std::fs::{self, File};

use camino::Utf8Path;

/// Copies the metadata of the file at `path` to the file that will replace it. Returns `false` if the replacement would
/// lose metadata or hard links. The file must then be overwritten instead.
#[cfg(unix)]
pub(crate) fn copy(path: &Utf8Path, metadata: &fs::Metadata, new: &File) -> bool {
    use std::os::unix::fs::MetadataExt as _;
    metadata.nlink() == 1
        && copy_owner(metadata, new)
        && attributes::copy(path, new)
        // Last, because changing the owner clears bits of the mode.
        && new.set_permissions(metadata.permissions()).is_ok()
}

/// Copies the metadata of the file at `path` to the file that will replace it.
#[cfg(not(unix))]
pub(crate) fn copy(_: &Utf8Path, metadata: &fs::Metadata, new: &File) -> bool {
    new.set_permissions(metadata.permissions()).is_ok()
}

#[cfg(unix)]
fn copy_owner(old: &fs::Metadata, new: &File) -> bool {
    use std::os::unix::fs::{MetadataExt as _, fchown};
    let is_equal = |new: fs::Metadata| (new.uid(), new.gid()) == (old.uid(), old.gid());
    new.metadata().is_ok_and(is_equal) || fchown(new, Some(old.uid()), Some(old.gid())).is_ok()
}

#[cfg(any(target_os = "linux", target_os = "android", target_vendor = "apple"))]
mod attributes {
    use std::ffi::{CStr, CString};
    use std::fs::File;

    use camino::Utf8Path;
    use rustix::fs::{XattrFlags, fgetxattr, fsetxattr, getxattr, listxattr};
    use rustix::io::{Errno, Result};

    /// Size limit in Linux for the list of names and for a value, in bytes.
    const LONGEST: usize = 1 << 16;

    /// Copies the extended attributes. Returns whether the new file has all of them.
    pub(super) fn copy(path: &Utf8Path, new: &File) -> bool {
        match names(path) {
            Ok(names) => names.iter().all(|name| copy_one(path, name, new).is_ok()),
            // The file system has no extended attributes.
            Err(error) => error == Errno::NOTSUP,
        }
    }

    fn names(path: &Utf8Path) -> Result<Vec<CString>> {
        let mut buffer = vec![0; LONGEST];
        let length = listxattr(path.as_str(), &mut buffer)?;
        buffer.truncate(length);
        Ok(buffer
            .split_inclusive(|byte| *byte == 0)
            .filter_map(|name| CString::from_vec_with_nul(name.to_vec()).ok())
            .collect())
    }

    fn copy_one(path: &Utf8Path, name: &CStr, new: &File) -> Result<()> {
        let (mut value, mut other) = (vec![0; LONGEST], vec![0; LONGEST]);
        let length = getxattr(path.as_str(), name, &mut value)?;
        value.truncate(length);
        // The system sets some attributes of new files itself, and rejects changes of them.
        let is_equal = fgetxattr(new, name, &mut other).is_ok_and(|length| other.get(..length) == Some(&value));
        if is_equal { Ok(()) } else { fsetxattr(new, name, &value, XattrFlags::empty()) }
    }
}

#[cfg(all(unix, not(any(target_os = "linux", target_os = "android", target_vendor = "apple"))))]
mod attributes {
    use std::fs::File;

    use camino::Utf8Path;

    /// The tools cannot read extended attributes on this system, so none are copied.
    pub(super) fn copy(_: &Utf8Path, _: &File) -> bool {
        true
    }
}
