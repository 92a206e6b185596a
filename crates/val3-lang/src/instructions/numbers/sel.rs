use crate::declare::instruction;

instruction! {
    /// Gives one of two numbers by a condition.
    ///
    /// - `bCondition`: which one.
    /// - `nValue1`, `nValue2`: the number for `true` and the one for `false`. Both are computed in any case.
    /// - Result: the number chosen.
    ///
    /// ## Example
    /// ```val3
    /// bool bFragile
    /// num nSpeed
    ///   nSpeed=sel(bFragile,20,100)
    /// ```
    "sel": Numbers "3.2.3";
    function (bool bCondition, num nValue1, num nValue2) -> num;
}
