use crate::declare::instruction;

instruction! {
    /// Looks for a text in another one.
    ///
    /// - `sText1`: where to look.
    /// - `sText2`: what to look for.
    /// - Result: the position of its first character at the first place where it stands, counted from 0; -1 if it
    ///   stands nowhere.
    ///
    /// ## Example
    /// ```val3
    /// string sLine = "PICK;12"
    ///   if find(sLine,";")<0
    ///     logMsg("separator missing: "+sLine)
    ///   endIf
    /// ```
    "find": Strings "3.4.3";
    function (string sText1, string sText2) -> num;
}
