//! `taskCreate` (5.10): starts a program as a new task.

use crate::declare::instruction;

instruction! {
    /// Starts a program as a new task.
    ///
    /// - `sName`: the name of the task: 1 to 15 letters, digits and `_`, not in use in this application or library.
    /// - `nPriority`: 1 to 100, the maximum number of instruction lines that the task executes before the next task has
    ///   its turn.
    /// - `program`: the call that the task executes, written `p(...)` or `library:p(...)`. Local variables cannot be
    ///   passed by reference, because the task may outlive them.
    /// - Errors: 29 invalid name, 31 name in use, 40 and 41 without memory, 70 priority out of range.
    ///
    /// Its arguments have no parentheses. The task ends when its program ends.
    ///
    /// ## Example
    /// ```val3
    /// string sMessage
    /// program read(string& x_sMessage)
    /// begin
    ///   x_sMessage="ready"
    /// end
    ///   taskCreate "reader",10,read(sMessage)
    ///   wait(taskStatus("reader")==-1)
    ///   putln(sMessage)
    /// ```
    "taskCreate": Tasks "5.10", errors [29, 31, 40, 41, 70];
    modifier (string sName, num nPriority, program program);
}
