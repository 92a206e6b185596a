//! `getLatch` (9.2.3): reads the latched position.

use crate::call::{Call, Var};
use crate::declare::instruction;
use crate::fault::Result;
use crate::moves;
use crate::values::JointValue;

instruction! {
    /// Reads the position that the latch has stored.
    ///
    /// - `jPosition`: receives the position at the edge, accurate to 0.2 ms; unchanged if no position is stored.
    /// - Result: `true` if a position is stored; `false` before the edge, or if the latch was never armed.
    ///
    /// Only on CS8C controllers. The same position is read until `setLatch` arms the latch again.
    ///
    /// ## Example
    /// ```val3
    /// dio diSensor
    /// joint jEdge
    ///   setLatch(diSensor)
    ///   delay(0)
    ///   wait(getLatch(jEdge))
    ///   putln(jEdge.j1)
    /// ```
    "getLatch": Geometry "9.2.3";
    modifier (joint& jPosition) -> bool = latched;
}

fn latched(call: &mut Call<'_>, joint: Var<JointValue>) -> Result<bool> {
    let Some(position) = call.ports.latched_joint() else { return Ok(false) };
    let position = moves::of_arm(call, position);
    joint.set(call, position).map(|()| true)
}
