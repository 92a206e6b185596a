use crate::declare::instruction;

instruction! {
    /// Gives the angle that has a given tangent.
    ///
    /// - `nValue`: the tangent, any number.
    /// - Result: angle in degrees, -90 to 90.
    ///
    /// There is no form of two arguments: for a full turn, add 180 degrees where the x side is negative.
    ///
    /// ## Example
    /// ```val3
    /// num nAngle
    /// trsf trSide
    ///   if trSide.x!=0
    ///     nAngle=atan(trSide.y/trSide.x)
    ///   endIf
    /// ```
    "atan": Numbers "3.2.3";
    function (num nValue) -> num;
}
