use crate::declare::instruction;

instruction! {
    /// Gives the square root of a number.
    ///
    /// - `nValue`: 0 or more.
    /// - Result: the root.
    /// - Error 11: `nValue` is negative.
    ///
    /// ## Example
    /// ```val3
    /// num nDistance
    /// trsf trGap
    ///   nDistance=sqrt(trGap.x*trGap.x+trGap.y*trGap.y)
    /// ```
    "sqrt": Numbers "3.2.3", errors [11];
    function (num nValue) -> num;
}
