//! `here` (9.6.3): gives the position of a tool as a point.

use crate::declare::instruction;

instruction! {
    /// Gives the position of a tool as a point.
    ///
    /// - `tTool`: the tool.
    /// - `fReference`: the frame of the result.
    /// - Result: the position that the controller commands, with the present configuration of the arm.
    /// - Errors: 163 the frame has no reference frame, 164 the tool has no reference tool.
    ///
    /// `herej` gives the position of each axis.
    ///
    /// ## Example
    /// ```val3
    /// tool tGripper
    /// point pNow
    ///   pNow=here(tGripper,world)
    ///   putln(pNow.trsf.z)
    /// ```
    "here": Geometry "9.6.3", errors [163, 164];
    function (tool tTool, frame fReference) -> point;
}
