use crate::declare::instruction;

instruction! {
    /// Lets a halted task go on.
    ///
    /// - `sName`: the task, created by this application or library. A task that runs is left alone.
    /// - `nSkip`: where it goes on, in instruction lines from the one at which it stands: 0 that line, 1 the next
    ///   one, -1 the one before.
    /// - Errors: 30 no such task, 90 no instruction line there.
    ///
    /// ## Example
    /// ```val3
    ///   if taskStatus("robot")>1
    ///     // leave out the line that failed
    ///     taskResume("robot",1)
    ///   endIf
    /// ```
    "taskResume": Tasks "5.10", blocking, errors [30, 90];
    modifier (string sName, num nSkip);
}
