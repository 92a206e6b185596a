use crate::declare::instruction;

instruction! {
    /// Gives the natural logarithm of a number.
    ///
    /// - `nValue`: above 0.
    /// - Result: the logarithm to the base e.
    /// - Error 11: `nValue` is 0 or negative.
    ///
    /// ## Example
    /// ```val3
    /// num nTime
    /// num nLevel = 0.5
    ///   nTime=-5*ln(nLevel)
    /// ```
    "ln": Numbers "3.2.3", errors [11];
    function (num nValue) -> num;
}
