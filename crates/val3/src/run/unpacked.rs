//! Archive copy that a run reads and writes, because programs may write to `Disk://`.

use std::fs;

use camino::{Utf8Path, Utf8PathBuf};
use tempfile::TempDir;
use val3_analysis::paths::normalise;

use crate::in_memory::archive_around;
use crate::user_error::UserError;

/// Archive files in a temporary folder, which is deleted on drop.
pub(crate) struct Unpacked {
    /// Requested path in the folder.
    pub(crate) path: Utf8PathBuf,
    _folder: TempDir,
}

impl Unpacked {
    /// Unpacks the archive at `path` or above it. `None` if the path is not in an archive.
    ///
    /// # Errors
    /// The archive cannot be read, or the temporary folder cannot be written.
    pub(crate) fn of(path: &Utf8Path) -> Result<Option<Self>, UserError> {
        let path = normalise(path);
        let Some(archive) = archive_around(&path) else { return Ok(None) };
        let refused = |reason: String| UserError::new(format!("cannot read the archive `{archive}`: {reason}"));
        let files = val3_files::unpack(archive, |_| true).map_err(|fault| refused(fault.to_string()))?;
        let folder = TempDir::with_prefix("val3-").map_err(|error| refused(error.to_string()))?;
        let root = Utf8Path::from_path(folder.path());
        let root = root.ok_or_else(|| refused("the name of the temporary folder is not UTF-8".to_owned()))?;
        let root = root.join(archive.file_name().unwrap_or_default());
        for (inner, bytes) in files {
            let file = root.join(inner);
            let above = file.parent().unwrap_or(&root);
            fs::create_dir_all(above).map_err(|error| refused(error.to_string()))?;
            val3_files::replace(&file, &bytes).map_err(|error| refused(error.to_string()))?;
        }
        let inner = path.strip_prefix(archive).unwrap_or(Utf8Path::new(""));
        Ok(Some(Self { path: root.join(inner), _folder: folder }))
    }
}
