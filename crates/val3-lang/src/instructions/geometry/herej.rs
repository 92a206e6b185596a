//! `herej` (9.2.3): returns the current joint position.

use crate::call::Call;
use crate::declare::instruction;

instruction! {
    /// Gives the position of each axis.
    ///
    /// - Result: with power, the position that the controller commands; without, the position that the encoders
    ///   measure, which shivers a little. It is new every 4 ms.
    ///
    /// `here` gives the same as a point.
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

fn position(call: &mut Call<'_>) -> [f64; 6] {
    call.ports.commanded_joint()
}
