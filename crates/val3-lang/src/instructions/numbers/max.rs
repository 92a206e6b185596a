use crate::declare::instruction;

instruction! {
    /// Gives the larger of two numbers.
    ///
    /// - `nX`, `nY`: any numbers.
    /// - Result: the larger one.
    ///
    /// ## Example
    /// ```val3
    /// num nLeft
    /// num nDone = 7
    ///   nLeft=max(0,10-nDone)
    /// ```
    "max": Numbers "3.2.3";
    function (num nX, num nY) -> num;
}
