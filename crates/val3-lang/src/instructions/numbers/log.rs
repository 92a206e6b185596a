use crate::declare::instruction;

instruction! {
    /// Gives the decimal logarithm of a number.
    ///
    /// - `nValue`: above 0.
    /// - Result: the logarithm to the base 10.
    /// - Error 11: `nValue` is 0 or negative.
    ///
    /// ## Example
    /// ```val3
    /// num nDigits
    /// num nCount = 4711
    ///   nDigits=roundDown(log(nCount))+1
    /// ```
    "log": Numbers "3.2.3", errors [11];
    function (num nValue) -> num;
}
