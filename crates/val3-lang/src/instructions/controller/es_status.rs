//! `esStatus` (8.1): returns the state of the emergency stop circuit.

use crate::call::Call;
use crate::declare::instruction;

instruction! {
    /// Returns the state of the emergency stop circuit.
    ///
    /// - Result: 0 no emergency stop; 1 released, but not acknowledged yet; 2 the circuit is open, or a hardware fault
    ///   has to be repaired.
    ///
    /// ## Example
    /// ```val3
    ///   if esStatus()==2
    ///     popUpMsg("Emergency stop")
    ///   endIf
    /// ```
    "esStatus": Controller "8.1";
    function () -> num = es_status;
}

fn es_status(call: &mut Call<'_>) -> f64 {
    call.ports.es_status().into()
}
