//! `getPositionErr` (10.6): returns the axes' deviations from the commanded position.

use crate::call::Call;
use crate::declare::instruction;
use crate::moves;
use crate::values::JointValue;

instruction! {
    /// Returns the deviation of each axis from its commanded position.
    ///
    /// - Result: the difference between commanded and measured position, degrees or millimetres (inches).
    ///
    /// ## Example
    /// ```val3
    /// joint jError
    ///   jError=getPositionErr()
    ///   if abs(jError.j1)>0.5
    ///     logMsg("axis 1 lags behind")
    ///   endIf
    /// ```
    "getPositionErr": Motion "10.6";
    function () -> joint = error;
}

fn error(call: &mut Call<'_>) -> JointValue {
    let (commanded, measured) = (call.ports.commanded_joint(), call.ports.measured_joint());
    let mut error = commanded;
    error.iter_mut().zip(measured).for_each(|(axis, measured)| *axis -= measured);
    moves::of_arm(call, error)
}
