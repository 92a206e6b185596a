use crate::declare::instruction;

instruction! {
    /// Gives the largest whole number that is not above a number.
    ///
    /// - `nValue`: any number.
    /// - Result: `roundDown(7.8)` is 7, `roundDown(-7.8)` is -8.
    ///
    /// ## Example
    /// ```val3
    /// num nRow
    /// num nPart = 25
    ///   nRow=roundDown(nPart/12)
    /// ```
    "roundDown": Numbers "3.2.3";
    function (num nValue) -> num;
}
