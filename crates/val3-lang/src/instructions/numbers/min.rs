use crate::declare::instruction;

instruction! {
    /// Gives the smaller of two numbers.
    ///
    /// - `nX`, `nY`: any numbers.
    /// - Result: the smaller one.
    ///
    /// ## Example
    /// ```val3
    /// num nSpeed
    /// num nWanted = 120
    ///   nSpeed=min(nWanted,100)
    /// ```
    "min": Numbers "3.2.3";
    function (num nX, num nY) -> num;
}
