//! `$rotAngle`: returns the angle of a transformation's rotation.

use crate::declare::instruction;

instruction! {
    /// Returns the angle of a transformation's rotation.
    ///
    /// - `trPosition`: the transformation.
    /// - Result: the angle in degrees.
    ///
    /// ## Example
    /// ```val3
    /// trsf trOffset
    ///   if $rotAngle(trOffset)>5
    ///     popUpMsg("Part is turned too far")
    ///   endIf
    /// ```
    "$rotAngle": AddOns, with_add_on "Motion";
    function (trsf trPosition) -> num;
}
