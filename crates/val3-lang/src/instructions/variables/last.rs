use crate::declare::instruction;

instruction! {
    /// Gives the last key of a collection, in alphabetical order.
    ///
    /// - `variable`: the collection, without key.
    /// - Result: the key; `""` if the collection is empty.
    ///
    /// With `prev` it walks through the collection backwards.
    ///
    /// ## Example
    /// ```val3
    /// num nCount[""]
    /// string sKey
    ///   sKey=last(nCount)
    ///   while sKey!=""
    ///     putln(sKey)
    ///     sKey=prev(nCount[sKey])
    ///   endWhile
    /// ```
    "last": Variables "2.5.6";
    function (any& variable[""]) -> string;
}
