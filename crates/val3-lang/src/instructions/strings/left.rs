use crate::declare::instruction;

instruction! {
    /// Gives the first characters of a text.
    ///
    /// - `sText`: the text.
    /// - `nSize`: how many characters; the whole text if it has fewer.
    /// - Result: these characters.
    /// - Error 70: `nSize` is negative.
    ///
    /// ## Example
    /// ```val3
    /// string sLine = "PICK 12"
    ///   if left(sLine,4)=="PICK"
    ///     putln(right(sLine,2))
    ///   endIf
    /// ```
    "left": Strings "3.4.3", errors [70];
    function (string sText, num nSize) -> string;
}
