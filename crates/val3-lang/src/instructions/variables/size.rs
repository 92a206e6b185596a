use crate::declare::instruction;

instruction! {
    /// Tells how many values a variable holds.
    ///
    /// - `variable`: a whole array or collection, without index or key. A one-dimensional array may have an
    ///   index: then the part from that index on is counted.
    /// - `nDimension`: 1, 2 or 3, the dimension of an array that is asked for; without it, 1.
    /// - Result: the number of values; 1 for an element, 0 for a dimension that the array does not have.
    ///
    /// A one-dimensional array that a program got by reference counts only what the caller passed.
    ///
    /// ## Example
    /// ```val3
    /// num nGrid[4,6]
    /// string sNames[3]
    ///   put(size(sNames))
    ///   putln(size(nGrid,2))
    /// ```
    "size": Variables "2.5.4, 2.5.5";
    function (Whole variable) -> num;
    function (Whole variable, num nDimension) -> num;
}
