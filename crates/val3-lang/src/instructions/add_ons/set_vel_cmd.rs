//! `$setVelCmd`: sets the speed of a motion that `$velFrame`, `$velTool` or `$velJoint` has started.

use crate::declare::instruction;

instruction! {
    /// Sets the speed of a motion that `$velFrame`, `$velTool` or `$velJoint` has started.
    ///
    /// - `nSpeed`: the speeds along x, y, z and about these axes, or the speed of each axis; read only.
    ///
    /// ## Example
    /// ```val3
    /// tool tGripper
    /// mdesc mSlow
    /// num nSpeed[6]
    ///   $velTool(tGripper,mSlow)
    ///   nSpeed[2]=10
    ///   $setVelCmd(nSpeed)
    /// ```
    "$setVelCmd": AddOns, with_add_on "Velocity";
    modifier (num& nSpeed[]);
}
