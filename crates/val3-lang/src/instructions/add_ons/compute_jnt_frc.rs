//! `$computeJntFrc`: computes the axes' torques or forces for a motion.

use crate::declare::instruction;

instruction! {
    /// Computes the torque or force that each axis needs for a motion.
    ///
    /// - `jPosition`: the position of each axis.
    /// - `nSpeed`, `nAcceleration`: the speed and acceleration of each axis; read only.
    /// - `nForce`: receives the torque or force of each axis.
    ///
    /// ## Example
    /// ```val3
    /// num nSpeed[6]
    /// num nAcceleration[6]
    /// num nForce[6]
    ///   $computeJntFrc(herej(),nSpeed,nAcceleration,nForce)
    ///   putln(nForce[1])
    /// ```
    "$computeJntFrc": AddOns, with_add_on "Motion";
    modifier (joint jPosition, num& nSpeed[], num& nAcceleration[], num& nForce[]);
}
