//! Bodies of HTTP requests: a plain message, or a message of several parts (MTOM), whose first part is the envelope.

use crate::error::SoapError;
use crate::version::SoapVersion;

/// Maximum number of parts. Requests of the interface contain no attachments.
const MOST_PARTS: usize = 16;

/// Finds the envelope in an HTTP body.
///
/// # Errors
/// The content type is no type of SOAP messages, or the parts are incomplete.
pub fn envelope<'a>(content_type: &str, body: &'a [u8]) -> Result<&'a [u8], SoapError> {
    let essence = content_type.split(';').next().unwrap_or_default().trim();
    let is_plain =
        [SoapVersion::V11, SoapVersion::V12].iter().any(|version| essence.eq_ignore_ascii_case(version.content_type()));
    if is_plain {
        return Ok(body);
    }
    if !essence.eq_ignore_ascii_case("multipart/related") {
        let reason = "the content type must be text/xml, application/soap+xml or multipart/related";
        return Err(SoapError::Transport(reason));
    }
    let boundary = parameter(content_type, "boundary").filter(|boundary| (1..=70).contains(&boundary.len()));
    let boundary = boundary.ok_or(SoapError::Transport("the content type has no valid boundary"))?;
    let start = parameter(content_type, "start");
    let mut first = None;
    for part in parts(body, &boundary)? {
        let (head, content) = split_once(part, b"\r\n\r\n").ok_or(INCOMPLETE)?;
        if start.is_none() || content_id(head) == start {
            return Ok(content);
        }
        first = first.or(Some(content));
    }
    first.ok_or(INCOMPLETE)
}

/// Error of a message without its end.
const INCOMPLETE: SoapError = SoapError::Transport("the message of several parts is not complete");

/// Parts between the boundaries, each with its head.
fn parts<'a>(body: &'a [u8], boundary: &str) -> Result<Vec<&'a [u8]>, SoapError> {
    let delimiter = format!("\r\n--{boundary}");
    let opening = delimiter.as_bytes().get(2..).unwrap_or_default();
    let mut rest = match body.strip_prefix(opening) {
        Some(rest) => rest,
        None => split_once(body, delimiter.as_bytes()).ok_or(INCOMPLETE)?.1,
    };
    let mut parts = Vec::new();
    while !rest.starts_with(b"--") {
        if parts.len() >= MOST_PARTS {
            return Err(SoapError::TooLarge("16 parts"));
        }
        let (part, after) = split_once(rest, delimiter.as_bytes()).ok_or(INCOMPLETE)?;
        parts.push(part);
        rest = after;
    }
    Ok(parts)
}

/// Content identifier in the head of a part.
fn content_id(head: &[u8]) -> Option<String> {
    let lines = std::str::from_utf8(head).ok()?.lines();
    lines
        .filter_map(|line| line.split_once(':'))
        .find_map(|(name, value)| name.trim().eq_ignore_ascii_case("content-id").then(|| value.trim().to_owned()))
}

/// Parameter value in a content type, without quotation marks.
fn parameter(content_type: &str, name: &str) -> Option<String> {
    let mut rest = content_type.split_once(';')?.1;
    loop {
        let (key, after) = rest.split_once('=')?;
        let after = after.trim_start();
        let (value, after) = match after.strip_prefix('"') {
            Some(quoted) => {
                let (value, after) = quoted.split_once('"')?;
                (value, after.split_once(';').map_or("", |(_, after)| after))
            }
            None => after.split_once(';').unwrap_or((after, "")),
        };
        if key.trim().eq_ignore_ascii_case(name) {
            return Some(value.trim().to_owned());
        }
        rest = after;
    }
}

fn split_once<'a>(bytes: &'a [u8], delimiter: &[u8]) -> Option<(&'a [u8], &'a [u8])> {
    let at = bytes.windows(delimiter.len()).position(|window| window == delimiter)?;
    Some((bytes.get(..at)?, bytes.get(at + delimiter.len()..)?))
}

#[cfg(test)]
mod tests {
    use super::*;

    const TWO: &[u8] = b"--b\r\nContent-ID: <a>\r\n\r\none\r\n--b\r\ncontent-id: <x>\r\n\r\n<two/>\r\n--b--\r\n";

    #[test]
    fn the_named_part_is_the_envelope() {
        let related = |rest: &str| format!("Multipart/Related; type=\"application/xop+xml\"{rest}");
        assert_eq!(envelope(&related("; boundary=b; start=\"<x>\""), TWO), Ok(&b"<two/>"[..]));
        assert_eq!(envelope(&related(";boundary=\"b\""), TWO), Ok(&b"one"[..]));
        assert_eq!(envelope(&related(";boundary=b;start=<other>"), TWO), Ok(&b"one"[..]));
        for (rest, body) in
            [("", TWO), (";boundary=b", b"--b\r\n\r\nx"), (";boundary=c", TWO), (";boundary=b", b"--b--")]
        {
            assert!(envelope(&related(rest), body).is_err(), "{rest}");
        }
    }

    #[test]
    fn other_content_types_are_rejected() {
        assert_eq!(envelope("text/xml; charset=utf-8", b"x"), Ok(&b"x"[..]));
        assert_eq!(envelope("application/soap+xml;action=\"\"", b"x"), Ok(&b"x"[..]));
        for other in ["", "text/plain", "application/x-www-form-urlencoded", "multipart/form-data; boundary=b"] {
            assert!(envelope(other, b"x").is_err(), "{other}");
        }
    }
}
