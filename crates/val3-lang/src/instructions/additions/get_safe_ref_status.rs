//! `getSafeRefStatus`: returns the state of the safety referencing of the arm.

use crate::call::Call;
use crate::declare::instruction;

instruction! {
    /// Returns the state of the safety referencing of the arm.
    ///
    /// - Result: a status number, whose meaning depends on the controller.
    ///
    /// On CS9 controllers.
    ///
    /// ## Example
    /// ```val3
    /// version s8.10
    ///   putln(getSafeRefStatus())
    /// ```
    "getSafeRefStatus": Additions, since 8;
    function () -> num = get_safe_ref_status;
}

fn get_safe_ref_status(call: &mut Call<'_>) -> f64 {
    call.ports.safe_reference()
}
