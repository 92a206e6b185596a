use crate::declare::instruction;

instruction! {
    /// Keeps a number within two bounds.
    ///
    /// - `nValue`: any number.
    /// - `nMin`, `nMax`: the bounds.
    /// - Result: `nValue`, or the bound that it exceeds.
    ///
    /// ## Example
    /// ```val3
    /// num nSpeed
    /// num nWanted = 140
    ///   nSpeed=limit(nWanted,1,100)
    /// ```
    "limit": Numbers "3.2.3";
    function (num nValue, num nMin, num nMax) -> num;
}
