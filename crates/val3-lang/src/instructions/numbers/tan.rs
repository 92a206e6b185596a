use crate::declare::instruction;

instruction! {
    /// Gives the tangent of an angle.
    ///
    /// - `nAngle`: angle in degrees.
    /// - Result: the tangent; very large near 90 degrees.
    ///
    /// ## Example
    /// ```val3
    /// num nHeight
    /// num nSlope = 12
    ///   nHeight=500*tan(nSlope)
    /// ```
    "tan": Numbers "3.2.3";
    function (num nAngle) -> num;
}
