use crate::declare::instruction;

instruction! {
    /// Puts other text in the place of characters of a text.
    ///
    /// - `sText`: the text, which stays as it is.
    /// - `sReplacement`: what comes in; it may be longer or shorter than what goes.
    /// - `nSize`: how many characters go.
    /// - `nPosition`: the first of them, counted from 0; beyond the end nothing changes.
    /// - Result: the new text, at most 128 bytes.
    /// - Error 70: `nSize` or `nPosition` is negative.
    ///
    /// ## Example
    /// ```val3
    /// string sLine = "12,5"
    /// num nComma
    ///   nComma=find(sLine,",")
    ///   if nComma>=0
    ///     sLine=replace(sLine,".",1,nComma)
    ///   endIf
    /// ```
    "replace": Strings "3.4.3", errors [70];
    function (string sText, string sReplacement, num nSize, num nPosition) -> string;
}
