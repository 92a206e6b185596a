use crate::declare::instruction;

instruction! {
    /// Gives the last characters of a text.
    ///
    /// - `sText`: the text.
    /// - `nSize`: how many characters; the whole text if it has fewer.
    /// - Result: these characters.
    /// - Error 70: `nSize` is negative.
    ///
    /// ## Example
    /// ```val3
    /// string sFile = "log.txt"
    ///   if right(sFile,4)==".txt"
    ///     putln(sFile)
    ///   endIf
    /// ```
    "right": Strings "3.4.3", errors [70];
    function (string sText, num nSize) -> string;
}
