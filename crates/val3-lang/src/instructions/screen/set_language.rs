use crate::declare::instruction;

instruction! {
    /// Changes the language in which the controller speaks.
    ///
    /// - `sLanguage`: the name of a translation that is installed on the controller (`getLanguage` lists names).
    /// - Result: `false` if it is not installed.
    ///
    /// ## Example
    /// ```val3
    ///   if setLanguage("francais")==false
    ///     logMsg("French is not installed")
    ///   endIf
    /// ```
    "setLanguage": Screen "4.3";
    modifier (string sLanguage) -> bool;
}
