use crate::declare::instruction;

instruction! {
    /// Gives the angle that has a given sine.
    ///
    /// - `nValue`: the sine, -1 to 1.
    /// - Result: angle in degrees, -90 to 90.
    /// - Error 11: `nValue` is outside -1 to 1. A quotient can exceed 1 by a rounding error: `limit` it.
    ///
    /// ## Example
    /// ```val3
    /// num nAngle
    /// num nHeight = 40
    ///   nAngle=asin(limit(nHeight/80,-1,1))
    /// ```
    "asin": Numbers "3.2.3", errors [11];
    function (num nValue) -> num;
}
