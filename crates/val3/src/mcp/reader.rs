//! Output of a process, read on a thread up to a limit.

use std::io::Read;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use std::sync::atomic::Ordering::Relaxed;
use std::thread::{self, JoinHandle};

/// Largest output in bytes.
const LIMIT: usize = 16 << 20;

/// Reads an output until its end or the limit.
pub(super) struct OutputReader {
    thread: JoinHandle<Vec<u8>>,
    is_full: Arc<AtomicBool>,
}

impl OutputReader {
    /// Starts a thread that reads the output.
    pub(super) fn of(output: Option<impl Read + Send + 'static>) -> Self {
        let is_full = Arc::new(AtomicBool::new(false));
        let full = Arc::clone(&is_full);
        let thread = thread::spawn(move || {
            let mut bytes = Vec::new();
            if let Some(output) = output {
                // After a read error, the bytes read so far are the output.
                let _ = output.take(LIMIT as u64).read_to_end(&mut bytes);
            }
            full.store(bytes.len() >= LIMIT, Relaxed);
            bytes
        });
        Self { thread, is_full }
    }

    /// Whether the output has reached the limit, so that its process may block on further output forever.
    pub(super) fn is_full(&self) -> bool {
        self.is_full.load(Relaxed)
    }

    /// Waits for the end of the output, and returns its text.
    pub(super) fn text(self) -> String {
        let bytes = self.thread.join().unwrap_or_default();
        String::from_utf8_lossy(&bytes).into_owned()
    }
}
