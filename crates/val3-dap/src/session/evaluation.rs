//! Evaluation in a stack frame, for several requests.

use val3_debug::{DebugValue, DisplayFormat};
use val3_session::{Evaluation, EvaluationError, Purpose};
use val3_vm::FragmentContext;

use super::DebugSession;
use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::inspection::FrameHandle;
use crate::protocol::{ValueFormat, Variable};

impl DebugSession {
    /// Returns the number format of a request.
    pub(crate) fn format(&self, format: Option<&ValueFormat>) -> DisplayFormat {
        let hex = format.and_then(|format| format.hex).unwrap_or_default();
        DisplayFormat { hex, radians: self.start.settings.has_radians, exact: true, bare: false }
    }

    /// Returns the context of a stack frame; without a stack frame, of the first loaded application.
    ///
    /// # Errors
    /// The handle is stale, or no application is loaded.
    pub(crate) fn context(&self, frame: Option<i32>, run: &DebuggedRun<'_>) -> Result<FragmentContext, RequestFailure> {
        if let Some(frame) = frame {
            let FrameHandle { task, depth } = self.handles.frame(frame).ok_or(RequestFailure::Stale)?;
            return Ok(FragmentContext::Frame(task, depth));
        }
        let first = run.debugger.controller.vm.space.loaded().next().map(|(instance, _)| instance);
        first.map(FragmentContext::Instance).ok_or(RequestFailure::NoApplication)
    }

    /// Evaluates code, until the client cancels the present request. A change of the run is reported even if a later
    /// part of the code fails.
    ///
    /// # Errors
    /// The code is invalid, fails or is cancelled.
    pub(crate) fn evaluate_while(
        &mut self,
        context: FragmentContext,
        code: &str,
        purpose: Purpose,
        format: DisplayFormat,
        run: &mut DebuggedRun<'_>,
    ) -> Result<Evaluation, RequestFailure> {
        let controller = &mut run.debugger.controller;
        let (client, request) = (&mut self.client, self.request);
        let mut is_cancelled = false;
        let evaluated = run.evaluator.evaluate_while(controller, context, code, purpose, format, &mut || {
            is_cancelled = client.has_cancelled(request, "");
            !is_cancelled
        });
        self.evaluated(evaluated, is_cancelled, run)
    }

    /// Reports the change of the run by evaluated code, and converts its error.
    pub(super) fn evaluated(
        &mut self,
        evaluated: Result<Evaluation, EvaluationError>,
        is_cancelled: bool,
        run: &mut DebuggedRun<'_>,
    ) -> Result<Evaluation, RequestFailure> {
        let changes_run = match &evaluated {
            Ok(evaluation) => evaluation.changes_run,
            Err(error) => error.done().is_some_and(|done| done.changes_run),
        };
        if changes_run {
            self.run_changed(run);
        }
        evaluated
            .map_err(|error| if is_cancelled { RequestFailure::Cancelled } else { RequestFailure::rejected(error) })
    }

    /// Converts a value for the client.
    pub(crate) fn shown(&mut self, value: DebugValue, run: &mut DebuggedRun<'_>) -> Variable {
        self.handles.variable(value, &mut run.debugger.controller)
    }
}
