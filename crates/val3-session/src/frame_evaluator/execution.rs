//! Execution of statements that can stop at breakpoints in called programs.

use std::iter;

use val3_debug::{Debugger, DisplayFormat, ExecutionEnd, ExecutionLimits};
use val3_lang::ports::TaskNumber;
use val3_vm::{FragmentContext, FragmentEnd};

use super::evaluation::{Evaluation, EvaluationError};
use super::{EvaluatedCode, FrameEvaluator, PORTION, PORTIONS, Purpose};

/// Requests during an execution, which are read about every millisecond.
pub struct ExecutionRequests<'a> {
    /// Whether the statements may continue.
    pub may_go_on: &'a mut dyn FnMut() -> bool,
    /// Whether statements that may not continue stop where they are, instead of their end.
    pub is_paused: &'a dyn Fn() -> bool,
}

impl FrameEvaluator {
    /// Executes code in a stack frame of a stopped task like [`evaluate_while`](Self::evaluate_while). Statements stop at
    /// breakpoints in called programs; [`Evaluation::stop`] is the stop.
    ///
    /// # Errors
    /// Like [`evaluate_while`](Self::evaluate_while).
    pub fn execute(
        &mut self,
        debugger: &mut Debugger,
        task: TaskNumber,
        depth: usize,
        text: &str,
        format: DisplayFormat,
        requests: ExecutionRequests<'_>,
    ) -> Result<Evaluation, EvaluationError> {
        let ExecutionRequests { may_go_on, is_paused } = requests;
        let (context, purpose) = (FragmentContext::Frame(task, depth), Purpose::Execute);
        let target = self.targets.of_context(&debugger.controller.vm, context)?;
        let is_single = self.is_expression(&target, text) || self.is_assignment(&target, text);
        if is_single {
            return self.evaluate_while(&mut debugger.controller, context, text, purpose, format, may_go_on);
        }
        let EvaluatedCode { fragment, .. } = self.compiled(&target, text, purpose)?;
        let mut grants = iter::repeat_n(PORTION, PORTIONS).take_while(|_| may_go_on());
        let limits = ExecutionLimits { grants: &mut grants, stops_at_limit: is_paused };
        let execution = debugger.execute(&fragment, task, depth, limits);
        let done = Evaluation::new(execution.events, true);
        match execution.end {
            ExecutionEnd::Stopped(stop) => Ok(Evaluation { stop: Some(stop), ..done }),
            ExecutionEnd::Over(FragmentEnd::Done | FragmentEnd::Value(()), _) => Ok(done),
            ExecutionEnd::Over(end, line) => Err(EvaluationError::ended_at(&end, line.as_ref(), done)),
        }
    }
}
