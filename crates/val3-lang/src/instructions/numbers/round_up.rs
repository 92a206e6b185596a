use crate::declare::instruction;

instruction! {
    /// Gives the smallest whole number that is not below a number.
    ///
    /// - `nValue`: any number.
    /// - Result: `roundUp(7.8)` is 8, `roundUp(-7.8)` is -7.
    ///
    /// ## Example
    /// ```val3
    /// num nLayers
    /// num nParts = 25
    ///   nLayers=roundUp(nParts/12)
    /// ```
    "roundUp": Numbers "3.2.3";
    function (num nValue) -> num;
}
