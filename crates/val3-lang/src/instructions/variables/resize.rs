use crate::declare::instruction;

instruction! {
    /// Gives one dimension of an array another size.
    ///
    /// - `variable`: the array, without index. No local variable.
    /// - `nDimension`: 1, 2 or 3, the dimension that changes.
    /// - `nSize`: its new size. Values are added or dropped at the end; new ones have the default of their type.
    /// - Errors: 40 without memory, 70 above 9999 values (up to s7) or for a size that is not possible.
    ///
    /// Making room takes time that is not bounded: not for a loop that must be fast.
    ///
    /// ## Example
    /// ```val3
    /// num nGrid[4,6]
    ///   resize(nGrid,2,8)
    /// ```
    "resize": Variables "2.5.5", errors [40, 70];
    modifier (Whole variable, num nDimension, num nSize);
}
