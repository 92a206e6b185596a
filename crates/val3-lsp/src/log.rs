//! Log file for troubleshooting.

use std::io::{self, Write as _};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Instant;

use camino::Utf8Path;
use val3_files::LogFile;

/// Writes lines with the time since the start, in seconds. Without a log file it writes nothing. Clones write to the
/// same file.
#[derive(Clone)]
pub(crate) struct ServerLog {
    file: Option<Arc<Mutex<LogFile>>>,
    started: Instant,
}

impl ServerLog {
    /// Opens the log file and empties it.
    pub(crate) fn open(path: Option<&Utf8Path>) -> io::Result<Self> {
        let file = path.map(LogFile::open).transpose().map_err(io::Error::other)?;
        Ok(Self { file: file.map(Mutex::new).map(Arc::new), started: Instant::now() })
    }

    /// Writes a line. A write error is ignored, because a full disk must not stop the server.
    pub(crate) fn write(&self, line: &str) {
        if let Some(file) = self.file.as_deref() {
            let mut file = file.lock().unwrap_or_else(PoisonError::into_inner);
            let _ = writeln!(file, "{:9.3} {line}", self.started.elapsed().as_secs_f64());
        }
    }
}
