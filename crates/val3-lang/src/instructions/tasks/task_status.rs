use crate::declare::instruction;

instruction! {
    /// Tells how a task is doing.
    ///
    /// - `sName`: the task, created by this application or library.
    /// - Result: 1 it runs (a task that waits runs), 0 it is halted, -1 there is none; every other number is the
    ///   run-time error that stopped it.
    ///
    /// ## Example
    /// ```val3
    /// num nStatus
    ///   nStatus=taskStatus("robot")
    ///   if nStatus>1
    ///     logMsg("robot: error "+toString("",nStatus))
    ///   endIf
    /// ```
    "taskStatus": Tasks "5.10";
    function (string sName) -> num;
}
