//! `herej` (9.2.3): returns the current joint position.

use crate::call::Call;
use crate::declare::instruction;
use crate::moves;
use crate::values::JointValue;

instruction! {
    /// Returns the position of each axis.
    ///
    /// - Result: with power, the commanded position; without power, the position measured by the encoders, which
    ///   fluctuates slightly. It is updated every 4 ms.
    ///
    /// `here` returns the position as a point.
    ///
    /// ## Example
    /// ```val3
    /// joint jNow
    ///   jNow=herej()
    ///   putln(jNow.j1)
    /// ```
    "herej": Geometry "9.2.3", role(Position);
    function () -> joint = position;
}

fn position(call: &mut Call<'_>) -> JointValue {
    let commanded = call.ports.commanded_joint();
    moves::of_arm(call, commanded)
}
