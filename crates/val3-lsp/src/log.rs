//! The log file, for finding the cause of a problem.

use std::fs::File;
use std::io::{self, Write as _};
use std::sync::Arc;
use std::time::Instant;

use camino::Utf8Path;

/// Writes lines with the time since the start; nothing where no file was asked for. Clones write to the same file.
#[derive(Clone)]
pub(crate) struct Log {
    file: Option<Arc<File>>,
    started: Instant,
}

impl Log {
    /// Opens a file, which is emptied.
    pub(crate) fn open(path: Option<&Utf8Path>) -> io::Result<Self> {
        Ok(Self { file: path.map(File::create).transpose()?.map(Arc::new), started: Instant::now() })
    }

    /// Writes a line. A full disk must not stop the server.
    pub(crate) fn write(&self, line: &str) {
        if let Some(mut file) = self.file.as_deref() {
            let _ = writeln!(file, "{:9.3} {line}", self.started.elapsed().as_secs_f64());
        }
    }
}
