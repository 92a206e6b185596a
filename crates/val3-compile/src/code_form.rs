//! Forms of code: without extras, with counters, with stops for a debugger.

/// Form of an image's code.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum CodeForm {
    /// No extras, for the fastest run.
    #[default]
    Plain,
    /// Counters: the virtual machine counts the executions of lines and branch sides.
    Counted,
    /// Operations at `endWhile` and `endFor`, before which a debugger can stop a task.
    Debugged,
}
