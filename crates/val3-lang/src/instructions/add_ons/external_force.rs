//! `$externalForce`: estimates the external force on the arm, as if it acted on the tool centre point.

use crate::declare::instruction;

instruction! {
    /// Estimates the external force on the arm, as if it acted at the tool centre point.
    ///
    /// - `jPosition`: the position of each axis.
    /// - `tTool`: the tool.
    /// - `nJointForce`: the torque or force of each axis in excess of what the motion requires; read only.
    /// - `nToolForce`: receives the forces and torques at the tool centre point.
    ///
    /// ## Example
    /// ```val3
    /// tool tGripper
    /// num nJointForce[6]
    /// num nToolForce[6]
    ///   $externalForce(herej(),tGripper,nJointForce,nToolForce)
    ///   putln(nToolForce[2])
    /// ```
    "$externalForce": AddOns, with_add_on "Motion";
    modifier (joint jPosition, tool tTool, num& nJointForce[], num& nToolForce[]);
}
