//! `sioSet` (3.7.3): writes bytes to a serial channel.

use crate::call::{Arr, Call, Flow, IoRef};
use crate::declare::instruction;
use crate::fault::Result;
use crate::ports::Outgoing;
use crate::values::numbers::round;

instruction! {
    /// Writes bytes to a serial channel.
    ///
    /// - `siOutput`: the serial line or socket; a socket that is not connected is opened first.
    /// - `nData`: the bytes; each number is rounded and taken modulo 256. For an array, an index selects the first
    ///   element.
    /// - `nByte`: a single byte in place of the array, a form that programs on controllers use.
    /// - `nLength`: (s8) the number of bytes; by default the whole array.
    /// - Result: the number of bytes written, fewer than requested after a fault; -1 after the timeout.
    /// - Errors: 123 not linked, 125 the channel has failed.
    ///
    /// ## Example
    /// ```val3
    /// sio siHost
    /// num nBytes[3]
    ///   if sioSet(siHost,nBytes)!=3
    ///     logMsg("host is not connected")
    ///   endIf
    /// ```
    "sioSet": Io "3.7.3", blocking, errors [123, 125];
    modifier (sio siOutput, num& nData[]) -> num = set;
    modifier (sio siOutput, num& nData[], num nLength) -> num since 8 = set_some;
    modifier (sio siOutput, num nByte) -> num seen in_programs = set_byte;
}

fn set(call: &mut Call<'_>, line: IoRef, data: Arr<f64>) -> Result<Flow<f64>> {
    set_some(call, line, data, f64::INFINITY)
}

/// A length beyond the array size is limited to the array size.
fn set_some(call: &mut Call<'_>, line: IoRef, data: Arr<f64>, length: f64) -> Result<Flow<f64>> {
    // The cast saturates, and converts NaN to 0.
    let count = data.len(call)?.min(round(length) as usize);
    let numbers = (0..count).map(|index| data.get(call, index)).collect::<Result<Vec<_>>>()?;
    send(call, line, &numbers)
}

fn set_byte(call: &mut Call<'_>, line: IoRef, byte: f64) -> Result<Flow<f64>> {
    send(call, line, &[byte])
}

fn send(call: &mut Call<'_>, line: IoRef, numbers: &[f64]) -> Result<Flow<f64>> {
    let (first, waited) = (call.is_first(), call.waited());
    let reply = call.ports.send(line.port, Outgoing::Numbers(numbers), first, waited)?;
    Ok(match reply.flow(call) {
        Flow::Done(sent) => Flow::Done(sent.map_or(-1.0, |count| count as f64)),
        Flow::Wait(wait) => Flow::Wait(wait),
    })
}
