use crate::declare::instruction;

instruction! {
    /// Asks the safety controller to restart after a safety stop.
    ///
    /// - Result: `true` if the restart was accepted.
    ///
    /// On CS9 controllers.
    ///
    /// ## Example
    /// ```val3
    /// version s8.10
    ///   if setSafetyRestart()==false
    ///     logMsg("safety restart refused")
    ///   endIf
    /// ```
    "setSafetyRestart": Additions, since 8;
    modifier () -> bool;
}
