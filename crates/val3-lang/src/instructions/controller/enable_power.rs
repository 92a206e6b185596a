//! `enablePower` (8.1): switches on the power of the arm, in remote mode.

use crate::call::Call;
use crate::declare::instruction;

instruction! {
    /// Switches the power of the arm on, in remote mode.
    ///
    /// It does not wait: check `isPowered`. In any other working mode, and while the power is being cut, its only
    /// effect is a line in the log.
    ///
    /// ## Example
    /// ```val3
    ///   enablePower()
    ///   if watch(isPowered(),5)==false
    ///     popUpMsg("Arm power does not come on")
    ///   endIf
    /// ```
    "enablePower": Controller "8.1";
    modifier () = enable_power;
}

fn enable_power(call: &mut Call<'_>) {
    call.ports.enable_power();
}
