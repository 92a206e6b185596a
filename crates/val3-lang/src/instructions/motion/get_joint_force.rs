//! `getJointForce` (10.6): gives the torque or force of each motor, from its current.

use crate::declare::instruction;

instruction! {
    /// Gives the torque or force of each motor, from its current.
    ///
    /// - `nForce`: gets newton metres for a rotary axis, newtons for a linear one; one value an axis.
    /// - Error 70: the array has fewer values than the arm has axes.
    ///
    /// Weight, friction, inertia and noise are in it: only the difference to a reference measured under like conditions
    /// says something about a force from outside.
    ///
    /// ## Example
    /// ```val3
    /// num nForce[6]
    ///   getJointForce(nForce)
    ///   putln(nForce[2])
    /// ```
    "getJointForce": Motion "10.6", errors [70];
    modifier (num& nForce[]);
}
