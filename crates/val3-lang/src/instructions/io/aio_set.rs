//! `aioSet` (3.6.2): writes a number to a numerical output.

use crate::call::{Call, IoRef};
use crate::declare::instruction;
use crate::fault::Result;

instruction! {
    /// Writes a number to a numerical output.
    ///
    /// - `aiOutput`: the output.
    /// - `nValue`: the value, in the unit of its configuration.
    /// - Result: the actual value of the output: rounded for an output of whole numbers, and limited to its range.
    /// - Errors: 122 for an input, 123 not linked, 124 a protected output, 125 an output that does not respond.
    ///
    /// ## Example
    /// ```val3
    /// aio aiFlow
    /// num nFlow
    ///   nFlow=aioSet(aiFlow,12.3)
    /// ```
    "aioSet": Io "3.6.2", errors [122, 123, 124, 125];
    modifier (aio aiOutput, num nValue) -> num = write;
}

fn write(call: &mut Call<'_>, output: IoRef, value: f64) -> Result<f64> {
    call.ports.write_analog(output.port, value)
}
