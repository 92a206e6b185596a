use crate::declare::instruction;

instruction! {
    /// Gives the character with a Unicode code point.
    ///
    /// - `nCodePoint`: the code point; 0 to 127 are the ASCII characters.
    /// - Result: a string of that character; `""` if there is none.
    ///
    /// It writes what a string literal cannot: `chr(34)` is a quote, `chr(13)` a carriage return.
    ///
    /// ## Example
    /// ```val3
    /// sio sHost
    ///   sHost="name="+chr(34)+"gripper"+chr(34)
    /// ```
    "chr": Strings "3.4.3";
    function (num nCodePoint) -> string;
}
