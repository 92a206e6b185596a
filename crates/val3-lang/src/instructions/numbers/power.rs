use crate::declare::instruction;

instruction! {
    /// Gives a number raised to a power.
    ///
    /// - `nX`: the base, above 0.
    /// - `nY`: the exponent, any number.
    /// - Result: `nX` to the power of `nY`.
    /// - Error 11: `nX` is 0 or negative, or the result is too large.
    ///
    /// ## Example
    /// ```val3
    /// num nMask
    /// num nBit = 5
    ///   nMask=power(2,nBit)
    /// ```
    "power": Numbers "3.2.3", errors [11];
    function (num nX, num nY) -> num;
}
