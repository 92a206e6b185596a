use crate::declare::instruction;

instruction! {
    /// Adds a value to an array or a collection, or a text to a string.
    ///
    /// Of a container it makes room for one value, which gets the default of its type:
    ///
    /// - `variable`: the index before which an array grows, up to its size (then it grows at the end), or the new
    ///   key of a collection. Arrays of one dimension only, and no local variables.
    /// - Result: `true`; `false` if the key exists already, and nothing changes.
    /// - Errors: 20 and 21 for an index beyond the size or below 0, 40 without memory, 70 above 9999 values (s7).
    ///
    /// Of a string it yields a new string; alone on a line it has no effect:
    ///
    /// - `sText`, `sInsertion`, `nPosition`: the text, what is put into it, and before which character, counted
    ///   from 0; beyond the end it is appended. What exceeds 128 bytes is cut off.
    /// - Error 70: `nPosition` is negative.
    ///
    /// Making room takes time that is not bounded: not for a loop that must be fast.
    ///
    /// ## Example
    /// ```val3
    /// num nCount[""]
    /// string sPart = "bolt"
    ///   if !isDefined(nCount[sPart])
    ///     insert(nCount[sPart])
    ///   endIf
    ///   sPart=insert(sPart,"s",4)
    /// ```
    "insert": Variables "2.5.4, 3.4.3", errors [20, 21, 40, 70];
    modifier (Slot variable) -> bool;
    function (string sText, string sInsertion, num nPosition) -> string;
}
