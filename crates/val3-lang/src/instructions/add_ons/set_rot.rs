//! `$setRot`: returns the transformation that rotates about an axis.

use crate::declare::instruction;

instruction! {
    /// Returns the transformation that rotates about an axis.
    ///
    /// - `nAngle`: the angle in degrees.
    /// - `nX`, `nY`, `nZ`: the axis.
    /// - Result: the rotation; its translation is 0.
    ///
    /// ## Example
    /// ```val3
    /// trsf trTurn
    ///   trTurn=$setRot(45,0,0,1)
    /// ```
    "$setRot": AddOns, with_add_on "Motion";
    function (num nAngle, num nX, num nY, num nZ) -> trsf;
}
