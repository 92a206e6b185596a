//! `$getRot`: returns the axis and the angle of a transformation's rotation.

use crate::declare::instruction;

instruction! {
    /// Returns the axis and the angle of a transformation's rotation.
    ///
    /// - `trPosition`: the transformation.
    /// - `nX`, `nY`, `nZ`: receive the axis, a vector of length 1.
    /// - Result: the angle in degrees.
    ///
    /// ## Example
    /// ```val3
    /// trsf trOffset
    /// num nX
    /// num nY
    /// num nZ
    /// num nAngle
    ///   nAngle=$getRot(trOffset,nX,nY,nZ)
    ///   putln(nAngle)
    /// ```
    "$getRot": AddOns, with_add_on "Motion";
    function (trsf trPosition, num& nX, num& nY, num& nZ) -> num;
}
