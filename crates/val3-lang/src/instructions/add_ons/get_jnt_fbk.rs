//! `$getJntFbk`: returns the joint position as measured by the encoders.

use crate::call::Call;
use crate::declare::instruction;
use crate::moves;
use crate::values::JointValue;

instruction! {
    /// Returns the position of each axis as measured by the encoders.
    ///
    /// - Result: the measured position; `herej` returns the commanded position.
    ///
    /// ## Example
    /// ```val3
    /// joint jNow
    ///   jNow=$getJntFbk()
    ///   putln(jNow.j1)
    /// ```
    "$getJntFbk": AddOns, with_add_on "Expansion";
    function () -> joint = position;
}

fn position(call: &mut Call<'_>) -> JointValue {
    let measured = call.ports.measured_joint();
    moves::of_arm(call, measured)
}
