//! `sioGet` (3.7.3): reads bytes from a serial channel.

use crate::call::{Arr, Call, Flow, IoRef};
use crate::declare::instruction;
use crate::fault::Result;

instruction! {
    /// Reads bytes from a serial channel.
    ///
    /// - `siInput`: the serial line or socket; a socket that is not connected is opened first.
    /// - `nData`: receives the bytes, each 0 to 255. A single variable receives one byte; for an array, an index
    ///   selects the first element. Reading ends when the array is full or no more bytes have arrived.
    /// - Result: the number of bytes read; -1 if no byte arrived within the timeout of the channel.
    /// - Errors: 70 without a variable for the bytes, 123 not linked, 125 the channel has failed.
    ///
    /// It waits for the first byte; other tasks continue.
    ///
    /// ## Example
    /// ```val3
    /// sio siHost
    /// num nBytes[48]
    /// num nRead
    ///   nRead=sioGet(siHost,nBytes)
    ///   if nRead<0
    ///     logMsg("host is silent")
    ///   endIf
    /// ```
    "sioGet": Io "3.7.3", blocking, errors [70, 123, 125];
    modifier (sio siInput, num& nData[]) -> num = get;
}

fn get(call: &mut Call<'_>, line: IoRef, data: Arr<f64>) -> Result<Flow<f64>> {
    let most = data.len(call)?;
    let waited = call.waited();
    let reply = call.ports.receive(line.port, most, waited)?;
    let read = match reply.flow(call) {
        Flow::Done(Some(read)) => read,
        Flow::Done(None) => return Ok(Flow::Done(-1.0)),
        Flow::Wait(wait) => return Ok(Flow::Wait(wait)),
    };
    for (index, byte) in read.iter().enumerate().take(most) {
        data.set(call, index, f64::from(*byte))?;
    }
    Ok(Flow::Done(read.len() as f64))
}
