use crate::declare::instruction;

instruction! {
    /// Shows a message in a window above whatever the pendant shows.
    ///
    /// - `sText`: the message. It stays until the operator confirms it; the program does not wait.
    /// - `nLevel`: (s8) its kind, a number.
    ///
    /// ## Example
    /// ```val3
    /// dio diGuard
    ///   if diGuard==false
    ///     popUpMsg("Close the guard")
    ///   endIf
    /// ```
    "popUpMsg": Screen "4.3";
    modifier (string sText);
    modifier (string sText, num nLevel) since 8;
}
