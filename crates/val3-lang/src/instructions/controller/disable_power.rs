//! `disablePower` (8.1): cuts the power of the arm and waits until it is off.

use crate::call::{Call, Flow, Wait};
use crate::declare::instruction;

instruction! {
    /// Cuts the power of the arm and waits until it is off.
    ///
    /// A moving arm is first stopped on its path. Recorded moves are kept and continue after `enablePower`.
    ///
    /// ## Example
    /// ```val3
    ///   disablePower()
    ///   putln("power is off")
    /// ```
    "disablePower": Controller "8.1", blocking;
    modifier () = disable_power;
}

fn disable_power(call: &mut Call<'_>) -> Flow {
    if call.is_first() {
        call.ports.disable_power();
    }
    if call.ports.is_power_off() { Flow::Done(()) } else { Flow::Wait(Wait::FOR_OTHERS) }
}
