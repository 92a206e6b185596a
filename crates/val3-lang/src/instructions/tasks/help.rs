use crate::declare::instruction;

instruction! {
    /// Explains a run-time error in the language of the controller.
    ///
    /// - `nErrorCode`: the number, as `taskStatus` gives it.
    /// - Result: the explanation.
    ///
    /// ## Example
    /// ```val3
    /// num nStatus
    ///   nStatus=taskStatus("robot")
    ///   if nStatus>1
    ///     popUpMsg(help(nStatus))
    ///   endIf
    /// ```
    "help": Tasks "5.10";
    function (num nErrorCode) -> string;
}
