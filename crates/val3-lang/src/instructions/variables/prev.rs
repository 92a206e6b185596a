use crate::declare::instruction;

instruction! {
    /// Gives the key that precedes another one in a collection, in alphabetical order.
    ///
    /// - `variable`: the collection with the key at which to start.
    /// - Result: the preceding key; `""` before the first one.
    ///
    /// ## Example
    /// ```val3
    /// num nCount[""]
    /// string sKey
    ///   sKey=last(nCount)
    ///   if sKey!=""
    ///     putln(prev(nCount[sKey]))
    ///   endIf
    /// ```
    "prev": Variables "2.5.6";
    function (Slot variable) -> string;
}
