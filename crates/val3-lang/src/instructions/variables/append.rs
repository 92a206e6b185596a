use crate::declare::instruction;

instruction! {
    /// Adds one value at the end of a one-dimensional array.
    ///
    /// - `variable`: the array, without index. No local variable, and no array of two or three dimensions.
    /// - The new value has the default of its type; the size grows by one.
    /// - Errors: 40 without memory, 70 above 9999 values (up to s7).
    ///
    /// Making room takes time that is not bounded: not for a loop that must be fast.
    ///
    /// ## Example
    /// ```val3
    /// string sNames[1]
    ///   append(sNames)
    ///   sNames[size(sNames)-1]="bolt"
    /// ```
    "append": Variables "2.5.5", errors [40, 70];
    modifier (Whole variable);
}
