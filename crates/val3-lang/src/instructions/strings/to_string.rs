use crate::declare::instruction;

instruction! {
    /// Writes a number as text.
    ///
    /// - `sFormat`: `"size.precision"`: the least number of characters, filled with blanks on the left, and the
    ///   number of decimals. Each may be missing: `".2"`, `"8"`, `""`; it then counts as 0.
    /// - `nValue`: the number. Zeros at the end of the decimals become blanks; the part before the point is never cut.
    /// - Result: the text: `toString(".4",3.141592)` is `"3.1416"`, `toString("",3.14)` is `"3"`.
    /// - Error 70: a format that is none.
    ///
    /// ## Example
    /// ```val3
    /// num nWeight = 12.345
    ///   putln("weight "+toString(".2",nWeight)+" kg")
    /// ```
    "toString": Strings "3.4.3", errors [70];
    function (string sFormat, num nValue) -> string;
}
