//! Functions and counts of requests (MODBUS Application Protocol V1.1b3, section 6).
//!
//! `modbus-core` decodes a request without these checks, and reads beyond the data if a count is greater than the data.

use std::ops::RangeInclusive;

use modbus_core::Exception;

/// Size of a request with an address and a value or a count, in bytes.
const FIXED: usize = 5;

/// Size of the part before the values of a request that writes several values, in bytes.
const BEFORE_VALUES: usize = 6;

/// Size of a request with an address and two masks, in bytes.
const MASKS: usize = 7;

/// Values of a written bit.
const BITS: [[u8; 2]; 2] = [[0xFF, 0], [0, 0]];

/// Checks that a request has a supported function, a permitted count, and the data for the count.
pub(super) fn check(request: &[u8]) -> Result<(), Exception> {
    let is_correct = match request.first() {
        Some(1 | 2) => is_read(request, 1..=2000),
        Some(3 | 4) => is_read(request, 1..=125),
        Some(5) => request.len() == FIXED && request.get(3..).is_some_and(|value| BITS.iter().any(|bit| bit == value)),
        Some(6) => request.len() == FIXED,
        Some(15) => is_write(request, 1..=1968, |count| count.div_ceil(8)),
        Some(16) => is_write(request, 1..=123, |count| count * 2),
        Some(22) => request.len() == MASKS,
        Some(23) => is_exchange(request),
        _ => return Err(Exception::IllegalFunction),
    };
    if is_correct { Ok(()) } else { Err(Exception::IllegalDataValue) }
}

/// Whether a request reads a permitted number of values.
fn is_read(request: &[u8], counts: RangeInclusive<usize>) -> bool {
    request.len() == FIXED && count(request).is_some_and(|count| counts.contains(&count))
}

/// Whether a request writes a permitted number of values, and contains as many bytes as they need.
fn is_write(request: &[u8], counts: RangeInclusive<usize>, bytes: fn(usize) -> usize) -> bool {
    let Some(count) = count(request).filter(|count| counts.contains(count)) else { return false };
    let stated = request.get(FIXED).copied().map(usize::from);
    stated == Some(bytes(count)) && request.len() == BEFORE_VALUES + bytes(count)
}

/// Whether function 23 reads and writes permitted numbers of words. The first address and count belong to the read range,
/// the second address and count to the write range.
fn is_exchange(request: &[u8]) -> bool {
    let read = request.get(..FIXED).is_some_and(|read| is_read(read, 1..=125));
    read && request.get(FIXED - 1..).is_some_and(|written| is_write(written, 1..=121, |count| count * 2))
}

fn count(request: &[u8]) -> Option<usize> {
    let [high, low] = request.get(3..FIXED)?.try_into().ok()?;
    Some(usize::from(u16::from_be_bytes([high, low])))
}
