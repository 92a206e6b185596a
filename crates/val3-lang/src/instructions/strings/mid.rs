use crate::declare::instruction;

instruction! {
    /// Gives characters from the middle of a text.
    ///
    /// - `sText`: the text.
    /// - `nSize`: how many characters; fewer if the text ends before.
    /// - `nPosition`: the first of them, counted from 0. The size comes first, the position last.
    /// - Result: these characters.
    /// - Error 70: `nSize` or `nPosition` is negative.
    ///
    /// ## Example
    /// ```val3
    /// string sLine = "hello wild world"
    ///   // "wild"
    ///   putln(mid(sLine,4,6))
    /// ```
    "mid": Strings "3.4.3", errors [70];
    function (string sText, num nSize, num nPosition) -> string;
}
