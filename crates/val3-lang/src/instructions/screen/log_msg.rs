use crate::declare::instruction;

instruction! {
    /// Writes a message to the event log of the controller.
    ///
    /// - `sText`: the message; date, time and the mark `USR` are put before it.
    /// - `nLevel`: (s8) its kind: 1 information, 2 warning, 3 error.
    /// - Result: `false` if so much is being logged that the message was lost.
    ///
    /// ## Example
    /// ```val3
    /// string sMessage = "gripper lost a part"
    ///   while logMsg(sMessage)==false
    ///     delay(0)
    ///   endWhile
    /// ```
    "logMsg": Screen "4.3";
    modifier (string sText) -> bool;
    modifier (string sText, num nLevel) -> bool since 8;
}
