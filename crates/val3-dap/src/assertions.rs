//! Failed assertions of tests, which stop a run as errors do.

use val3_debug::{
    BreakpointId, DisplayFormat, ProgramBreakpoint, ProgramName, ScopeKind, TaskFrame, frames, scopes, values,
};
use val3_lang::ports::TaskNumber;
use val3_lang::test_names::{ASSERTIONS, FAILURE};
use val3_machine::controller::Controller;

/// Identity of the breakpoint on failed assertions. Identities of clients' breakpoints begin with 1.
pub(crate) const ID: BreakpointId = BreakpointId(0);

/// Returns the breakpoint on the library program that each failed assertion calls.
pub(crate) fn breakpoint() -> ProgramBreakpoint {
    ProgramBreakpoint::new(ID, ProgramName { library: Some(ASSERTIONS.to_owned()), program: FAILURE.to_owned() })
}

/// Whether a task with these frames, the innermost first, reports a failure.
pub(crate) fn has_failed(frames: &[TaskFrame]) -> bool {
    frames.first().is_some_and(|frame| is_of_library(frame) && frame.program == FAILURE)
}

/// Whether a stack frame is in the assertion library.
pub(crate) fn is_of_library(frame: &TaskFrame) -> bool {
    frame.application == ASSERTIONS
}

/// Returns the message of the failed assertion that a task reports.
pub(crate) fn message(controller: &mut Controller, task: TaskNumber) -> Option<String> {
    if !has_failed(&frames(&controller.vm, task)) {
        return None;
    }
    let parameters = scopes(&controller.vm, task, 0).into_iter().find(|scope| scope.kind == ScopeKind::Parameters)?;
    let text = values(controller, &parameters.inside, 0..1, DisplayFormat::default()).into_iter().next()?.shown;
    let inside = text.strip_prefix('"').and_then(|text| text.strip_suffix('"'));
    Some(inside.map_or_else(|| text.clone(), str::to_owned))
}
