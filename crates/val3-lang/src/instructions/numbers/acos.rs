use crate::declare::instruction;

instruction! {
    /// Gives the angle that has a given cosine.
    ///
    /// - `nValue`: the cosine, -1 to 1.
    /// - Result: angle in degrees, 0 to 180.
    /// - Error 11: `nValue` is outside -1 to 1. A quotient can exceed 1 by a rounding error: `limit` it.
    ///
    /// ## Example
    /// ```val3
    /// num nAngle
    /// num nReach = 40
    ///   nAngle=acos(limit(nReach/80,-1,1))
    /// ```
    "acos": Numbers "3.2.3", errors [11];
    function (num nValue) -> num;
}
