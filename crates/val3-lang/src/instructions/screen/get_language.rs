use crate::declare::instruction;

instruction! {
    /// Gives the language in which the controller speaks.
    ///
    /// - Result: its name, such as `"english"`, `"francais"`, `"deutsch"`, `"italiano"`, `"espanol"`, `"chinese"`.
    ///
    /// ## Example
    /// ```val3
    /// string sMessage
    ///   switch getLanguage()
    ///     case "deutsch"
    ///       sMessage="Achtung!"
    ///     break
    ///     default
    ///       sMessage="Warning!"
    ///     break
    ///   endSwitch
    ///   putln(sMessage)
    /// ```
    "getLanguage": Screen "4.3";
    function () -> string;
}
