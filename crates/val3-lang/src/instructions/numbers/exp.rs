use crate::declare::instruction;

instruction! {
    /// Gives the power of e, the base of the natural logarithm.
    ///
    /// - `nValue`: the exponent.
    /// - Result: e to the power of `nValue`.
    /// - Error 11: the result is too large for a number.
    ///
    /// ## Example
    /// ```val3
    /// num nGain
    /// num nSeconds = 2
    ///   nGain=1-exp(-nSeconds/5)
    /// ```
    "exp": Numbers "3.2.3", errors [11];
    function (num nValue) -> num;
}
