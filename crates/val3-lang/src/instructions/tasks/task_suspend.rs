use crate::declare::instruction;

instruction! {
    /// Halts a task.
    ///
    /// - `sName`: the task, created by this application or library. One that is halted already stays so.
    /// - Error 30: no such task.
    ///
    /// `taskResume` lets it go on. The arm does not stop for it: that is `stopMove`.
    ///
    /// ## Example
    /// ```val3
    ///   if taskStatus("robot")==1
    ///     taskSuspend("robot")
    ///   endIf
    /// ```
    "taskSuspend": Tasks "5.10", errors [30];
    modifier (string sName);
}
