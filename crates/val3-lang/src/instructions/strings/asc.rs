use crate::declare::instruction;

instruction! {
    /// Gives the Unicode code point of a character of a text.
    ///
    /// - `sText`: the text.
    /// - `nPosition`: the character, counted from 0.
    /// - Result: its code point; -1 if `nPosition` is negative or beyond the end.
    ///
    /// ## Example
    /// ```val3
    /// string sLine = "A1"
    ///   if asc(sLine,0)==65
    ///     putln("command A")
    ///   endIf
    /// ```
    "asc": Strings "3.4.3";
    function (string sText, num nPosition) -> num;
}
