//! `isPowered` (8.1): returns whether the arm has power.

use crate::call::Call;
use crate::declare::instruction;

instruction! {
    /// Returns whether the arm has power.
    ///
    /// - Result: `true` with power; `false` without power, and while it is being switched on.
    ///
    /// ## Example
    /// ```val3
    ///   wait(isPowered())
    /// ```
    "isPowered": Controller "8.1";
    function () -> bool = is_powered;
}

fn is_powered(call: &mut Call<'_>) -> bool {
    call.ports.is_powered()
}
