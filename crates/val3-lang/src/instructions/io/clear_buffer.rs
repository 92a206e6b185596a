//! `clearBuffer` (3.7.3): discards the data that a serial channel has received and no task has read.

use crate::call::{Call, IoRef};
use crate::declare::instruction;
use crate::fault::Result;

instruction! {
    /// Discards the data that a serial channel has received and no task has read.
    ///
    /// - `siVariable`: the serial line or socket. A socket is closed as well; it opens again when it is next used.
    /// - Result: the number of discarded characters; -1 for a socket that is already closed.
    /// - Error 123: not linked.
    ///
    /// ## Example
    /// ```val3
    /// sio siHost
    ///   clearBuffer(siHost)
    ///   siHost="READY"
    /// ```
    "clearBuffer": Io "3.7.3", errors [123];
    modifier (sio siVariable) -> num = clear;
}

fn clear(call: &mut Call<'_>, line: IoRef) -> Result<f64> {
    let cleared = call.ports.clear_line(line.port)?;
    Ok(cleared.map_or(-1.0, |count| count as f64))
}
