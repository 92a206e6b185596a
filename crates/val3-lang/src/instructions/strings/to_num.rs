use crate::declare::instruction;

instruction! {
    /// Reads the number at the start of a text and yields the rest.
    ///
    /// - `sString`: the text.
    /// - `nValue`: gets the number; unchanged if there is none.
    /// - `bReport`: gets `true` if the text starts with a number, else `false`.
    /// - Result: the text from the next number on, `""` if none follows; the whole text if it starts with no number.
    ///
    /// ## Example
    /// ```val3
    /// string sBuffer = "+90 0.0 -7.6"
    /// num nValue
    /// bool bOk
    ///   do
    ///     sBuffer=toNum(sBuffer,nValue,bOk)
    ///     if bOk
    ///       putln(nValue)
    ///     endIf
    ///   until sBuffer=="" or bOk==false
    /// ```
    "toNum": Strings "3.4.3";
    modifier (string sString, num& nValue, bool& bReport) -> string;
}
