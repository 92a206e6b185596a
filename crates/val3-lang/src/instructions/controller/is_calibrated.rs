//! `isCalibrated` (8.1): returns whether every axis of the arm is calibrated.

use crate::call::Call;
use crate::declare::instruction;

instruction! {
    /// Returns whether every axis of the arm is calibrated.
    ///
    /// - Result: `false` if at least one axis is not calibrated.
    ///
    /// ## Example
    /// ```val3
    ///   if isCalibrated()==false
    ///     popUpMsg("Calibrate the arm")
    ///   endIf
    /// ```
    "isCalibrated": Controller "8.1";
    function () -> bool = is_calibrated;
}

fn is_calibrated(call: &mut Call<'_>) -> bool {
    call.ports.is_calibrated()
}
