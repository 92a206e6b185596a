//! `$velFrame`: starts motion by speed along the axes of a frame.

use crate::declare::instruction;

instruction! {
    /// Starts motion by speed along the axes of a frame.
    ///
    /// - `fReference`: the frame.
    /// - `tTool`, `mDesc`: tool, and limits of speed and acceleration.
    /// - Result: the id of the move.
    ///
    /// `$setVelCmd` then sets the speed.
    ///
    /// ## Example
    /// ```val3
    /// tool tGripper
    /// mdesc mSlow
    /// num nSpeed[6]
    ///   $velFrame(world,tGripper,mSlow)
    ///   nSpeed[2]=-10
    ///   $setVelCmd(nSpeed)
    /// ```
    "$velFrame": AddOns, with_add_on "Velocity";
    modifier (frame fReference, tool tTool, mdesc mDesc) -> num;
}
