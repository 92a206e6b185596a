use crate::declare::instruction;

instruction! {
    /// Gives the first key of a collection, in alphabetical order.
    ///
    /// - `variable`: the collection, without key.
    /// - Result: the key; `""` if the collection is empty.
    ///
    /// With `next` it walks through the collection.
    ///
    /// ## Example
    /// ```val3
    /// num nCount[""]
    /// string sKey
    ///   sKey=first(nCount)
    ///   while sKey!=""
    ///     putln(sKey)
    ///     sKey=next(nCount[sKey])
    ///   endWhile
    /// ```
    "first": Variables "2.5.6";
    function (any& variable[""]) -> string;
}
