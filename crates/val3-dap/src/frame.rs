//! Messages in their frames: a header with `Content-Length`, an empty line, the message.
//!
//! Reading blocks. The adapter reads on a separate thread, as the language server does: tokio would also read stdin on
//! a blocking thread, and that thread delays the end of its runtime. The same code serves sockets.

use std::io::{self, BufRead, Read as _, Write};

use crate::error::{HeaderError, ReadError};
use crate::message::{MessageContent, ProtocolMessage};

/// Maximum header size, in bytes.
pub const HEADER_LIMIT: usize = 8 << 10;
/// Maximum message size, in bytes.
pub const BODY_LIMIT: u64 = 64 << 20;

/// Maximum number of garbage characters in an error.
const SHOWN: usize = 60;

/// Reads messages from a stream.
#[derive(Debug)]
pub struct MessageReader<R> {
    input: R,
    /// Length of the next body, if its header was already read together with garbage before it.
    length: Option<u64>,
}

/// Content length in a header, and garbage before it.
#[derive(Default)]
struct Header {
    length: Option<u64>,
    garbage: Option<String>,
}

impl<R: BufRead> MessageReader<R> {
    /// A reader of `input`.
    pub const fn new(input: R) -> Self {
        Self { input, length: None }
    }

    /// Reads one message. Returns `None` at the end of the input.
    ///
    /// Letter case and other headers make no difference. Garbage before a header is a separate error, and the next
    /// call reads the message after it.
    ///
    /// # Errors
    /// If the input cannot be read or is no message. [`ReadError::can_continue`] returns whether to call again.
    pub fn read(&mut self) -> Result<Option<ProtocolMessage>, ReadError> {
        let length = match self.length.take() {
            Some(length) => length,
            None => match self.header()? {
                None => return Ok(None),
                Some(Header { length, garbage: Some(garbage) }) => {
                    self.length = length;
                    return Err(HeaderError::Garbage(garbage).into());
                }
                Some(Header { length, garbage: None }) => length.ok_or(HeaderError::NoLength)?,
            },
        };
        Ok(Some(ProtocolMessage::parse(&self.body(length)?)?))
    }

    /// Reads up to the empty line after the header. Empty lines before it are skipped.
    fn header(&mut self) -> Result<Option<Header>, ReadError> {
        let mut header = Header::default();
        let mut seen = 0;
        loop {
            let mut line = Vec::new();
            let limit = u64::try_from(HEADER_LIMIT + 1 - seen).unwrap_or(0);
            self.input.by_ref().take(limit).read_until(b'\n', &mut line)?;
            if line.is_empty() {
                return if seen == 0 { Ok(None) } else { Err(HeaderError::Truncated.into()) };
            }
            let is_blank = line.trim_ascii().is_empty();
            if is_blank && seen > 0 {
                return Ok(Some(header));
            }
            if !is_blank {
                seen += line.len();
                if seen > HEADER_LIMIT {
                    return Err(HeaderError::HeaderSize.into());
                }
                header.add(line.trim_ascii())?;
            }
        }
    }

    fn body(&mut self, length: u64) -> Result<Vec<u8>, ReadError> {
        let mut body = Vec::new();
        self.input.by_ref().take(length).read_to_end(&mut body)?;
        if u64::try_from(body.len()).is_ok_and(|read| read == length) {
            Ok(body)
        } else {
            Err(HeaderError::Truncated.into())
        }
    }
}

impl Header {
    /// Adds a line. Garbage may precede `Content-Length` on its line, for example the rest of a message that was longer
    /// than its `Content-Length`.
    fn add(&mut self, line: &[u8]) -> Result<(), HeaderError> {
        const NAME: &[u8] = b"content-length:";
        let at = line.windows(NAME.len()).rposition(|part| part.eq_ignore_ascii_case(NAME));
        let (before, value) = match at.and_then(|at| Some((line.get(..at)?, line.get(at + NAME.len()..)?))) {
            Some((before, value)) => (before, Some(value)),
            None => (line, None),
        };
        if let Some(value) = value {
            self.length = Some(content_length(value.trim_ascii())?);
        }
        if !before.is_empty() && !is_header(before) {
            let text = String::from_utf8_lossy(before).chars().take(SHOWN).collect();
            self.garbage.get_or_insert(text);
        }
        Ok(())
    }
}

/// Whether a line has the form `Name: value`.
fn is_header(line: &[u8]) -> bool {
    let name = line.split(|byte| *byte == b':').next().unwrap_or_default();
    name.len() < line.len() && !name.is_empty() && name.iter().all(|byte| byte.is_ascii_alphanumeric() || *byte == b'-')
}

fn content_length(value: &[u8]) -> Result<u64, HeaderError> {
    if value.is_empty() || !value.iter().all(u8::is_ascii_digit) {
        let text = String::from_utf8_lossy(value).chars().take(SHOWN).collect();
        return Err(HeaderError::Length(text));
    }
    // A number with more digits than fit is too large as well.
    let length = str::from_utf8(value).ok().and_then(|digits| digits.parse().ok()).unwrap_or(u64::MAX);
    if length > BODY_LIMIT { Err(HeaderError::BodySize(length)) } else { Ok(length) }
}

/// Writes messages to a stream and numbers them.
#[derive(Debug)]
pub struct MessageWriter<W> {
    output: W,
    seq: i64,
}

impl<W: Write> MessageWriter<W> {
    /// A writer to `output`.
    pub const fn new(output: W) -> Self {
        Self { output, seq: 0 }
    }

    /// Writes one message, and returns its number.
    ///
    /// # Errors
    /// If the output cannot be written.
    pub fn write(&mut self, content: MessageContent) -> io::Result<i64> {
        self.seq += 1;
        self.pass_on(&ProtocolMessage { seq: self.seq, content })?;
        Ok(self.seq)
    }

    /// Writes a message from a different sender, with its number.
    ///
    /// # Errors
    /// If the output cannot be written.
    pub fn pass_on(&mut self, message: &ProtocolMessage) -> io::Result<()> {
        let body = serde_json::to_vec(message)?;
        let mut frame = format!("Content-Length: {}\r\n\r\n", body.len()).into_bytes();
        frame.extend(body);
        self.output.write_all(&frame)?;
        self.output.flush()
    }
}
