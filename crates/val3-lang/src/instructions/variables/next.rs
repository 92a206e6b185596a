use crate::declare::instruction;

instruction! {
    /// Gives the key that follows another one in a collection, in alphabetical order.
    ///
    /// - `variable`: the collection with the key at which to start.
    /// - Result: the following key; `""` behind the last one.
    ///
    /// ## Example
    /// ```val3
    /// num nCount[""]
    /// string sKey
    ///   sKey=first(nCount)
    ///   if sKey!=""
    ///     putln(next(nCount[sKey]))
    ///   endIf
    /// ```
    "next": Variables "2.5.6";
    function (Slot variable) -> string;
}
