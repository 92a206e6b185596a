use crate::declare::instruction;

instruction! {
    /// Takes a value out of an array or a collection, or characters out of a string.
    ///
    /// Of a container:
    ///
    /// - `variable`: the index or key to remove. What follows in an array moves up. Arrays of one dimension only,
    ///   and no local variables.
    /// - Result: `true` if the value was removed.
    /// - Errors: 20 and 21 for an index or key that is not there, 70 for the last value of an array, which must
    ///   keep one; a collection may become empty.
    ///
    /// Of a string it yields a new string; alone on a line it has no effect:
    ///
    /// - `sText`, `nSize`, `nPosition`: the text, how many characters go, and the first of them, counted from 0;
    ///   beyond the end nothing goes.
    /// - Error 70: `nSize` or `nPosition` is negative.
    ///
    /// ## Example
    /// ```val3
    /// num nCount[""]
    /// string sPart = "bolts"
    ///   if isDefined(nCount[sPart])
    ///     delete(nCount[sPart])
    ///   endIf
    ///   sPart=delete(sPart,1,4)
    /// ```
    "delete": Variables "2.5.4, 3.4.3", errors [20, 21, 70];
    modifier (Slot variable) -> bool;
    function (string sText, num nSize, num nPosition) -> string;
}
