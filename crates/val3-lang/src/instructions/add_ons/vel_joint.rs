//! `$velJoint`: starts motion by speed of the axes.

use crate::declare::instruction;

instruction! {
    /// Starts motion by speed of the axes.
    ///
    /// - `tTool`, `mDesc`: tool, and limits of speed and acceleration.
    ///
    /// `$setVelCmd` then sets the speed.
    ///
    /// ## Example
    /// ```val3
    /// tool tGripper
    /// mdesc mSlow
    /// num nSpeed[6]
    ///   $velJoint(tGripper,mSlow)
    ///   nSpeed[0]=5
    ///   $setVelCmd(nSpeed)
    /// ```
    "$velJoint": AddOns, with_add_on "Velocity";
    modifier (tool tTool, mdesc mDesc);
}
