//! `pointToJoint` (9.6.3): finds the position of each axis with which a tool reaches a point.

use crate::declare::instruction;

instruction! {
    /// Finds the position of each axis with which a tool reaches a point.
    ///
    /// - `tTool`: the tool.
    /// - `jInitial`: a position to start from: it decides what `ssame`, `esame`, `wsame` mean, and which turn of an
    ///   axis is taken that has several.
    /// - `pPosition`: the point with its wanted configuration.
    /// - `jResult`: gets the position; unchanged if there is none.
    /// - Result: `false` if the point is out of reach, or out of the limits in that configuration.
    /// - Errors: 81 a position for another kind of arm, 162 the point, 164 the tool has no reference.
    ///
    /// ## Example
    /// ```val3
    /// tool tGripper
    /// point pPick
    /// joint jPick
    ///   if pointToJoint(tGripper,herej(),pPick,jPick)==false
    ///     popUpMsg("The point is out of reach")
    ///   endIf
    /// ```
    "pointToJoint": Geometry "9.6.3", errors [81, 162, 164];
    modifier (tool tTool, joint jInitial, point pPosition, joint& jResult) -> bool;
}
