use crate::declare::instruction;

instruction! {
    /// Tells whether a value exists in an array or a collection, or a variable in a library.
    ///
    /// - `variable`: an index or key that need not exist, or a variable of a library interface.
    /// - Result: `true` if the value is there.
    ///
    /// Use it before a key is read, inserted or deleted. On a library it tells whether the library that is
    /// loaded has what its interface promises (compare `libExist`).
    ///
    /// ## Example
    /// ```val3
    /// num nCount[""]
    /// string sPart = "bolt"
    ///   if isDefined(nCount[sPart])
    ///     putln(nCount[sPart])
    ///   endIf
    /// ```
    "isDefined": Variables "2.5.4";
    function (Item variable) -> bool;
}
