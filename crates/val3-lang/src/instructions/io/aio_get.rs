//! `aioGet` (3.6.2): reads a numerical input or output.

use crate::call::{Call, IoRef};
use crate::declare::instruction;
use crate::fault::Result;

instruction! {
    /// Reads a numerical input or output.
    ///
    /// - `aiInput`: the signal.
    /// - Result: its value, in the unit of its configuration.
    /// - Errors: 123 not linked, 125 the device does not respond.
    ///
    /// ## Example
    /// ```val3
    /// aio aiPressure
    ///   wait(aioGet(aiPressure)>=4.5)
    /// ```
    "aioGet": Io "3.6.2", errors [123, 125];
    function (aio aiInput) -> num = read;
}

fn read(call: &mut Call<'_>, input: IoRef) -> Result<f64> {
    call.ports.read_analog(input.port)
}
