//! `$getPosFbk`: gives the position of a tool as the encoders measure it.

use crate::declare::instruction;

instruction! {
    /// Gives the position of a tool as the encoders measure it.
    ///
    /// - `tTool`: the tool.
    /// - `fReference`: the frame of the result.
    /// - Result: the measured position; `here` gives the commanded one.
    ///
    /// ## Example
    /// ```val3
    /// tool tGripper
    /// point pNow
    ///   pNow=$getPosFbk(tGripper,world)
    ///   putln(pNow.trsf.z)
    /// ```
    "$getPosFbk": AddOns, with_add_on "Expansion";
    function (tool tTool, frame& fReference) -> point;
}
