use crate::declare::instruction;

instruction! {
    /// Ends a task.
    ///
    /// - `sName`: the task, created by this application or library. If there is none, nothing happens.
    ///
    /// It returns when the task is gone, so that the name can be used again.
    ///
    /// ## Example
    /// ```val3
    ///   taskKill("robot")
    ///   resetMotion()
    /// ```
    "taskKill": Tasks "5.10", blocking;
    modifier (string sName);
}
