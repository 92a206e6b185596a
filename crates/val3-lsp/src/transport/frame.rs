//! Message frames: `Content-Length`, an empty line, the message.

use std::io::{self, BufRead, Read as _};

/// Size limit of a message header in bytes.
const HEAD_LIMIT: usize = 16 << 10;
/// Size limit of a message in bytes.
const BODY_LIMIT: usize = 256 << 20;

/// Framing error.
#[derive(Debug, PartialEq, Eq)]
pub(crate) enum FramingError {
    /// The header has no length; another frame may follow.
    Head,
    /// The length is no number, so the start of the next frame is unknown.
    Length,
    /// The frame is too large to continue.
    Size,
}

/// Frames a message.
pub(crate) fn frame(message: &[u8]) -> Vec<u8> {
    let mut framed = format!("Content-Length: {}\r\n\r\n", message.len()).into_bytes();
    framed.extend_from_slice(message);
    framed
}

/// Reads one message; `None` at the end of the input. Letter case, other headers and bytes before `Content-Length` are
/// ignored.
pub(crate) fn read_message(input: &mut impl BufRead) -> io::Result<Option<Result<Vec<u8>, FramingError>>> {
    let mut length = None;
    let mut seen = 0;
    loop {
        let mut line = Vec::new();
        let limit = u64::try_from(HEAD_LIMIT - seen).unwrap_or(0);
        if input.by_ref().take(limit).read_until(b'\n', &mut line)? == 0 {
            return Ok((seen >= HEAD_LIMIT).then_some(Err(FramingError::Size)));
        }
        seen += line.len();
        let line = String::from_utf8_lossy(&line);
        match line.trim() {
            "" if seen <= 2 => seen = 0,
            "" => break,
            line => length = length_in(line).or(length),
        }
    }
    match length {
        None => Ok(Some(Err(FramingError::Head))),
        Some(None) => Ok(Some(Err(FramingError::Length))),
        Some(Some(length)) if length > BODY_LIMIT => Ok(Some(Err(FramingError::Size))),
        Some(Some(length)) => {
            let mut body = vec![0; length];
            match input.read_exact(&mut body) {
                Ok(()) => Ok(Some(Ok(body))),
                Err(error) if error.kind() == io::ErrorKind::UnexpectedEof => Ok(None),
                Err(error) => Err(error),
            }
        }
    }
}

/// Length in a header line; `None` if the line has no length, `Some(None)` if the length is no number.
fn length_in(line: &str) -> Option<Option<usize>> {
    const NAME: &str = "content-length:";
    let at = line.to_ascii_lowercase().rfind(NAME)?;
    let length = line.get(at + NAME.len()..)?.trim();
    if !length.is_empty() && length.bytes().all(|byte| byte.is_ascii_digit()) {
        // A number that overflows counts as too large.
        return Some(Some(length.parse().unwrap_or(usize::MAX)));
    }
    Some(None)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn messages(mut input: &[u8]) -> Vec<Result<Vec<u8>, FramingError>> {
        std::iter::from_fn(|| read_message(&mut input).unwrap()).take(9).collect()
    }

    #[test]
    fn frames_are_found_between_garbage() {
        assert_eq!(messages(&frame(b"{}")), [Ok(b"{}".to_vec())]);
        let foreign = b"content-type: application/vscode-jsonrpc; charset=utf8\r\ncontent-length:2\n\n{}";
        assert_eq!(messages(foreign), [Ok(b"{}".to_vec())]);
        let garbage = b"hello\r\n\r\n\0\xffContent-Length: 2\r\n\r\n{}";
        assert_eq!(messages(garbage), [Err(FramingError::Head), Ok(b"{}".to_vec())]);
    }

    #[test]
    fn a_length_that_is_no_number_is_an_error() {
        for length in ["-1", "x", "", "1.5", "2 bytes"] {
            let message = format!("Content-Length: {length}\r\n\r\n{{}}");
            assert_eq!(messages(message.as_bytes()).first(), Some(&Err(FramingError::Length)), "{length}");
        }
    }

    #[test]
    fn an_end_within_a_frame_is_an_error() {
        assert_eq!(messages(b""), []);
        assert_eq!(messages(b"Content-Len"), []);
        assert_eq!(messages(b"Content-Length: 5\r\n\r\n{}"), []);
    }

    #[test]
    fn messages_that_are_too_large_are_refused() {
        assert_eq!(messages(b"Content-Length: 99999999999\r\n\r\n").first(), Some(&Err(FramingError::Size)));
        let digits = format!("Content-Length: {}\r\n\r\n", "9".repeat(50));
        assert_eq!(messages(digits.as_bytes()).first(), Some(&Err(FramingError::Size)));
        assert_eq!(messages(&vec![b'x'; HEAD_LIMIT + 10]).first(), Some(&Err(FramingError::Size)));
    }
}
