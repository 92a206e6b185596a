//! `$taskCallStack`: lists the calls that a task is executing.

use crate::declare::instruction;

instruction! {
    /// Lists the calls that a task is executing.
    ///
    /// - `sTask`: the task.
    /// - `sLines`: receives one line per call, in the form `project:program(), line n: code`.
    /// - Result: the number of calls.
    ///
    /// ## Example
    /// ```val3
    /// string sCalls[10]
    ///   if $taskCallStack("robot",sCalls)>0
    ///     logMsg(sCalls[0])
    ///   endIf
    /// ```
    "$taskCallStack": AddOns, with_add_on "Expansion";
    modifier (string sTask, string& sLines[]) -> num;
}
