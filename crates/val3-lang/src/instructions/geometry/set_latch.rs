//! `setLatch` (9.2.3): arms the position latch, so that the next rising edge of a fast input stores the position.

use crate::call::{Call, IoRef};
use crate::declare::instruction;
use crate::fault::Result;

instruction! {
    /// Arms the position latch: the next rising edge of a fast input stores the position.
    ///
    /// - `diInput`: a fast input (`fIn0`, `fIn1`); the signal has to be low and then high for at least 0.2 ms.
    /// - Errors: 70 for an input without latch, 123 not linked.
    ///
    /// Only on CS8C controllers. The latch is armed up to 0.2 ms later: add a `delay(0)` after it.
    ///
    /// ## Example
    /// ```val3
    /// dio diSensor
    /// joint jEdge
    ///   setLatch(diSensor)
    ///   delay(0)
    ///   if watch(getLatch(jEdge),5)
    ///     putln(jEdge.j1)
    ///   endIf
    /// ```
    "setLatch": Geometry "9.2.3", errors [70, 123];
    modifier (dio diInput) = arm;
}

fn arm(call: &mut Call<'_>, input: IoRef) -> Result<()> {
    call.ports.arm_latch(input.port)
}
