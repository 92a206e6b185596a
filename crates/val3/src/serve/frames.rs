//! Messages in sequence, as recordings and blocks contain them.

use std::io::{self, Write};

/// Kind of a message in a sequence.
#[derive(Debug, Clone, Copy)]
pub(crate) enum FrameKind {
    /// JSON object.
    Object = 0,
    /// Batch of samples.
    Samples = 1,
}

/// Writes a message: its kind, its length as `u32`, and its bytes.
///
/// # Errors
/// The output cannot be written, or the message is longer than 4 GiB.
pub(crate) fn write_frame(out: &mut impl Write, kind: FrameKind, bytes: &[u8]) -> io::Result<()> {
    let length = u32::try_from(bytes.len()).map_err(io::Error::other)?;
    out.write_all(&[kind as u8])?;
    out.write_all(&length.to_le_bytes())?;
    out.write_all(bytes)
}
