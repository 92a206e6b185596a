//! `getJointForce` (10.6): returns the motors' torques or forces, computed from their currents.

use crate::call::{Arr, Call};
use crate::declare::instruction;
use crate::fault::{Fault, Result};
use crate::runtime_errors::INVALID_PARAMETER;

instruction! {
    /// Returns the torque or force of each motor, computed from its current.
    ///
    /// - `nForce`: receives one value per axis: newton metres for a rotary axis, newtons for a linear axis.
    /// - Error 70: the array has fewer values than the arm has axes.
    ///
    /// The values include weight, friction, inertia and noise: only the difference from a reference measured under
    /// similar conditions indicates an external force.
    ///
    /// ## Example
    /// ```val3
    /// num nForce[6]
    ///   getJointForce(nForce)
    ///   putln(nForce[2])
    /// ```
    "getJointForce": Motion "10.6", errors [70];
    modifier (num& nForce[]) = force;
}

fn force(call: &mut Call<'_>, force: Arr<f64>) -> Result<()> {
    let axes = call.ports.arm().axes();
    if force.len(call)? < axes {
        return Err(Fault(INVALID_PARAMETER));
    }
    let values = call.ports.joint_force();
    force.set_all(call, values.into_iter().take(axes))
}
