//! `dioGet` (3.5.3): reads an array of digital signals as a binary number.

use crate::call::{Arr, Call, IoRef};
use crate::declare::instruction;
use crate::fault::Result;

instruction! {
    /// Reads an array of digital signals as a binary number.
    ///
    /// - `diArray`: the signals, the lowest bit first; read only. An index selects the first signal.
    /// - Result: `diArray[0]` counts 1, `diArray[1]` counts 2, `diArray[2]` counts 4, and so on.
    /// - Errors: 123 for a signal that is not linked, 125 for a signal that does not respond.
    ///
    /// ## Example
    /// ```val3
    /// dio diCode[4]
    /// num nCode
    ///   nCode=dioGet(diCode)
    /// ```
    "dioGet": Io "3.5.3", errors [123, 125];
    function (dio& diArray[]) -> num = read;
}

fn read(call: &mut Call<'_>, signals: Arr<IoRef>) -> Result<f64> {
    let ports: Vec<_> = signals.all(call)?.iter().map(|signal| signal.port).collect();
    call.ports.read_bits(&ports)
}
