//! `dioSet` (3.5.3): writes a number in binary to an array of digital outputs.

use crate::call::{Arr, Call, IoRef};
use crate::declare::instruction;
use crate::fault::Result;

instruction! {
    /// Writes a number in binary to an array of digital outputs.
    ///
    /// - `diArray`: the outputs, the lowest bit first. An index selects the first output.
    /// - `nValue`: its whole part is written; bits beyond the array are discarded.
    /// - Result: the number that the outputs then represent: with 4 outputs, 10 for 26.
    /// - Errors: 122 for an input, 123 not linked, 124 a protected output, 125 an output that does not respond.
    ///
    /// ## Example
    /// ```val3
    /// dio diTray[4]
    /// num nTray = 10
    ///   dioSet(diTray,nTray)
    /// ```
    "dioSet": Io "3.5.3", errors [122, 123, 124, 125];
    modifier (dio& diArray[], num nValue) -> num = write;
}

fn write(call: &mut Call<'_>, signals: Arr<IoRef>, value: f64) -> Result<f64> {
    let ports: Vec<_> = signals.all(call)?.iter().map(|signal| signal.port).collect();
    call.ports.write_bits(&ports, value)
}
