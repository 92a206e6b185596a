//! A library's files as a ZIP archive without encryption, for clients outside.

use std::io::{Cursor, Write as _};

use zip::result::ZipResult;
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, DateTime, ZipWriter};

use super::{FileFault, LibraryFiles};

impl LibraryFiles {
    /// Returns an archive with all files, whose paths are relative to the library's folder. The date of each file is
    /// 1980-01-01, so that equal files have equal archives.
    ///
    /// # Errors
    /// [`FileFault::ReadOnly`] for an encrypted library, [`FileFault::DiskFull`] if the files do not fit into an
    /// archive.
    pub fn zipped(&self) -> Result<Vec<u8>, FileFault> {
        if self.encrypted {
            return Err(FileFault::ReadOnly);
        }
        self.pack().map_err(|_| FileFault::DiskFull)
    }

    fn pack(&self) -> ZipResult<Vec<u8>> {
        let options = SimpleFileOptions::default()
            .compression_method(CompressionMethod::Deflated)
            .last_modified_time(DateTime::DEFAULT);
        let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
        for file in &self.files {
            archive.start_file(file.path.as_str(), options)?;
            archive.write_all(&file.bytes)?;
        }
        Ok(archive.finish()?.into_inner())
    }
}
