use crate::declare::instruction;

instruction! {
    /// Gives the sine of an angle.
    ///
    /// - `nAngle`: angle in degrees.
    /// - Result: -1 to 1.
    ///
    /// ## Example
    /// ```val3
    /// num nHeight
    /// num nAngle = 30
    ///   nHeight=200*sin(nAngle)
    /// ```
    "sin": Numbers "3.2.3";
    function (num nAngle) -> num;
}
