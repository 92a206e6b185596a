//! Evaluation in the stack frames of a run: expressions, statements, assignments, breakpoint conditions, completions.
//!
//! The database has the state of the application at its launch, so later edits of the files have no effect.

mod completions;
mod condition;
mod effects;
mod evaluation;
mod execution;
mod load;
mod log;
mod replace;
mod scratch;
mod target;

use std::iter;

use rustc_hash::FxHashMap;
use val3_analysis::body::{Stmt, StmtKind, body};
use val3_analysis::db::{Database, File};
use val3_analysis::infer::infer;
use val3_bytecode::Fragment;
use val3_compile::{FragmentScope, compile_expression, compile_statements};
use val3_debug::{
    CompiledExpression, DebugValue, DisplayFormat, Inside, LogMessage, NamedFragment, application_context, evaluate,
    expression_grant,
};
use val3_lang::instructions::AIO_SET;
use val3_lang::types::BaseType;
use val3_machine::controller::Controller;
use val3_vm::{FragmentContext, FragmentEnd, Vm};

use crate::application::Application;

pub use completions::FrameCompletion;
pub use condition::LineCondition;
pub use evaluation::{Evaluation, EvaluationError};
pub use execution::ExecutionRequests;
pub use load::LoadRequest;
pub use replace::ReplaceFault;

use effects::effect;
use replace::PatchedProgram;
use scratch::Scratch;
use target::{EvaluationContext, Targets};

/// Number of lines that statements execute between two checks for cancellation, about one millisecond of execution.
const PORTION: u32 = 100_000;

/// Maximum number of portions that statements may execute, about half a second of execution.
const PORTIONS: usize = 500;

/// Prefix that turns an expression into a statement.
const PRINT: &str = "?";

/// Evaluation purpose, which determines whether side effects are allowed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Purpose {
    /// Display of a value: an expression without side effects.
    Watch,
    /// Execution of statements: calls, assignments, output.
    Execute,
}

/// Compiled code of an evaluation.
struct EvaluatedCode {
    fragment: Fragment,
    /// Whether the code may change the run.
    has_effects: bool,
    /// Whether the code is a single assignment, which forces an input.
    forces_inputs: bool,
}

/// Evaluates code in the stack frames of a controller's tasks.
pub struct FrameEvaluator {
    targets: Targets,
    /// Programs that were changed while tasks executed them, by file.
    patched: FxHashMap<String, PatchedProgram>,
}

impl FrameEvaluator {
    /// Creates an evaluator for a controller that runs the image of `application`.
    #[must_use]
    pub fn new(application: Application) -> Self {
        Self { targets: Targets::new(application), patched: FxHashMap::default() }
    }

    /// File of a program with its database; `None` if no known application has read it.
    pub(crate) fn source_file(&self, path: &str) -> Option<(&Database, File)> {
        self.targets.source_file(path)
    }

    /// Evaluates code. Tasks, clock and arm are stopped during the evaluation, and no run-time error stops a task.
    /// A single assignment to an input forces it, like [`assign`](Self::assign).
    ///
    /// # Errors
    /// If the code is invalid for this purpose, or if a run-time error ends it.
    pub fn evaluate(
        &mut self,
        controller: &mut Controller,
        context: FragmentContext,
        text: &str,
        purpose: Purpose,
        format: DisplayFormat,
    ) -> Result<Evaluation, EvaluationError> {
        self.evaluate_while(controller, context, text, purpose, format, &mut || true)
    }

    /// Like [`evaluate`](Self::evaluate), but calls `may_go_on` about every millisecond to check whether the statements
    /// may continue.
    ///
    /// # Errors
    /// Like [`evaluate`](Self::evaluate), and also if the statements may not continue.
    pub fn evaluate_while(
        &mut self,
        controller: &mut Controller,
        context: FragmentContext,
        text: &str,
        purpose: Purpose,
        format: DisplayFormat,
        may_go_on: &mut dyn FnMut() -> bool,
    ) -> Result<Evaluation, EvaluationError> {
        let target = self.targets.of_context(&controller.vm, context)?;
        if purpose == Purpose::Execute
            && let Some((variable, value)) = self.analog_assignment(&target, text)
        {
            return self.assign(controller, context, variable, value, format).map(Evaluation::of_assignment);
        }
        let EvaluatedCode { fragment, has_effects, forces_inputs } = self.compiled(&target, text, purpose)?;
        let mut of_statements = iter::repeat_n(PORTION, PORTIONS).take_while(|_| may_go_on());
        let grants: &mut dyn Iterator<Item = u32> =
            if has_effects { &mut of_statements } else { &mut expression_grant() };
        controller.devices.state.io.force_inputs(forces_inputs);
        let (end, events) =
            evaluate(controller, NamedFragment { fragment: &fragment, text: text.trim() }, context, grants, format);
        controller.devices.state.io.force_inputs(false);
        let passed_stops = controller.vm.passed_stops();
        let done = Evaluation { passed_stops, ..Evaluation::new(events, has_effects) };
        match end {
            FragmentEnd::Value(value) => Ok(Evaluation { value: Some(value), ..done }),
            FragmentEnd::Done => Ok(done),
            end => Err(EvaluationError::ended(&end, done)),
        }
    }

    /// Compiles code for a purpose.
    fn compiled(
        &mut self,
        target: &EvaluationContext,
        text: &str,
        purpose: Purpose,
    ) -> Result<EvaluatedCode, EvaluationError> {
        if purpose == Purpose::Execute && !self.is_expression(target, text) {
            let forces_inputs = self.is_assignment(target, text);
            return Ok(EvaluatedCode { fragment: self.statements(target, text)?, has_effects: true, forces_inputs });
        }
        let (fragment, effect) = self.expression(target, text)?;
        match effect {
            Some(effect) if purpose == Purpose::Watch => Err(effect.into()),
            effect => Ok(EvaluatedCode { fragment, has_effects: effect.is_some(), forces_inputs: false }),
        }
    }

    /// Assigns an expression's value to a variable, an element, a field or an output. Returns the new value. An input
    /// is forced: it has the value as if the hardware had set it.
    ///
    /// # Errors
    /// If the target and value are invalid or do not match, or if a run-time error ends the assignment.
    pub fn assign(
        &mut self,
        controller: &mut Controller,
        context: FragmentContext,
        target_text: &str,
        value: &str,
        format: DisplayFormat,
    ) -> Result<DebugValue, EvaluationError> {
        let target = self.targets.of_context(&controller.vm, context)?;
        let fragment = self.assignment(&target, target_text, value).or_else(|error| match state_of(value) {
            Some(state) => self.assignment(&target, target_text, state),
            None => Err(error),
        })?;
        controller.devices.state.io.force_inputs(true);
        let (end, events) = evaluate(
            controller,
            NamedFragment { fragment: &fragment, text: target_text },
            context,
            &mut expression_grant(),
            format,
        );
        controller.devices.state.io.force_inputs(false);
        if end != FragmentEnd::Done {
            return Err(EvaluationError::ended(&end, Evaluation::new(events, true)));
        }
        let shown = self.evaluate(controller, context, target_text, Purpose::Watch, format)?;
        shown.value.ok_or_else(|| EvaluationError::from("it has no value"))
    }

    /// Assigns to a value inside another value, like [`assign`](Self::assign).
    ///
    /// # Errors
    /// Like [`assign`](Self::assign), and also if the value is computed from others.
    pub fn assign_child(
        &mut self,
        controller: &mut Controller,
        inside: &Inside,
        name: &str,
        value: &str,
        format: DisplayFormat,
    ) -> Result<DebugValue, EvaluationError> {
        let (context, path) = inside.expression(name).ok_or_else(|| {
            EvaluationError::from(format!("`{name}` is computed from other values and cannot be assigned to"))
        })?;
        let assigned = self.assign(controller, context, &path, value, format)?;
        Ok(DebugValue { name: name.to_owned(), ..assigned })
    }

    /// Compiles the condition of a breakpoint in a file.
    ///
    /// # Errors
    /// If the code is no `bool` without side effects in the file's program.
    pub fn condition(&mut self, vm: &Vm, file: &str, text: &str) -> Result<CompiledExpression, EvaluationError> {
        let target = self.targets.of_file(vm, file)?;
        self.compiled_condition(&target, text)
    }

    /// Compiles the condition of a breakpoint on data, with the variables of the application.
    ///
    /// # Errors
    /// If the code is no `bool` without side effects there.
    pub fn global_condition(&mut self, vm: &Vm, text: &str) -> Result<CompiledExpression, EvaluationError> {
        let target = self.targets.of_context(vm, application_context(vm))?;
        self.compiled_condition(&target, text)
    }

    fn compiled_condition(
        &mut self,
        target: &EvaluationContext,
        text: &str,
    ) -> Result<CompiledExpression, EvaluationError> {
        let is_dio = self.pure_expression(target, text)?.1 == Some(BaseType::Dio);
        let code = if is_dio { format!("({text})==true") } else { text.to_owned() };
        let (fragment, base) = self.pure_expression(target, &code)?;
        match base {
            Some(BaseType::Bool) => Ok(CompiledExpression { text: text.to_owned(), fragment }),
            _ => Err(EvaluationError::from("a condition is a bool, such as `nCount>3`")),
        }
    }

    /// Compiles the message of a log point in a file: text with expressions in braces. `{{` and `}}` are literal
    /// braces.
    ///
    /// # Errors
    /// If a brace is not closed, or if an expression cannot be evaluated in the file's program.
    pub fn log_message(&mut self, vm: &Vm, file: &str, text: &str) -> Result<LogMessage, EvaluationError> {
        let target = self.targets.of_file(vm, file)?;
        log::message(text, |code| {
            let (fragment, _) = self.pure_expression(&target, code)?;
            Ok(CompiledExpression { text: code.to_owned(), fragment })
        })
    }

    /// Whether the code is a single expression with a value.
    fn is_expression(&mut self, target: &EvaluationContext, text: &str) -> bool {
        let scratch = Scratch::new(&mut self.targets, target, "", text);
        let (db, file) = (scratch.db(), scratch.file());
        let inference = infer(db, target.project, file);
        let [stmt] = body(db, file).block.as_slice() else { return false };
        match &stmt.kind {
            StmtKind::Expr(id) => !inference.is_call_without_value(*id),
            _ => false,
        }
    }

    /// Whether the code is a single assignment.
    fn is_assignment(&mut self, target: &EvaluationContext, text: &str) -> bool {
        let scratch = Scratch::new(&mut self.targets, target, "", text);
        match body(scratch.db(), scratch.file()).block.as_slice() {
            [stmt] => matches!(stmt.kind, StmtKind::Assign { .. }),
            _ => false,
        }
    }

    /// Compiled expression, and a description if it has a side effect.
    fn expression(
        &mut self,
        target: &EvaluationContext,
        text: &str,
    ) -> Result<(Fragment, Option<String>), EvaluationError> {
        let scratch = Scratch::new(&mut self.targets, target, PRINT, text);
        if let Some(fault) = scratch.fault() {
            let is_statement = !text.trim().is_empty() && self.statements(target, text).is_ok();
            return Err(if is_statement { STATEMENT.into() } else { EvaluationError::Code(fault) });
        }
        let (db, file) = (scratch.db(), scratch.file());
        let effect = match body(db, file).block.as_slice() {
            [stmt] => match stmt.kind {
                StmtKind::Print(id) => effect(db, target.project, file, id),
                _ => return Err(EvaluationError::from(NO_EXPRESSION)),
            },
            _ => return Err(EvaluationError::from(NO_EXPRESSION)),
        };
        let scope = FragmentScope { image: &target.image, variables: &target.variables };
        let fragment = compile_expression(db, target.project, file, scope);
        Ok((fragment.map_err(|error| error.limit.to_string())?, effect))
    }

    /// Compiled expression without side effects, and its type.
    fn pure_expression(
        &mut self,
        target: &EvaluationContext,
        text: &str,
    ) -> Result<(Fragment, Option<BaseType>), EvaluationError> {
        match self.expression(target, text)? {
            (_, Some(effect)) => Err(effect.into()),
            (fragment, None) => {
                let base = fragment.value.as_ref().and_then(|value| value.kind.base_type());
                Ok((fragment, base))
            }
        }
    }

    /// Compiled statements.
    fn statements(&mut self, target: &EvaluationContext, text: &str) -> Result<Fragment, EvaluationError> {
        let scratch = Scratch::new(&mut self.targets, target, "", text);
        match scratch.fault() {
            Some(fault) => Err(EvaluationError::Code(fault)),
            None => compile(&scratch, target),
        }
    }

    /// Returns the parts of a single assignment to an `aio` variable; `None` for other code.
    fn analog_assignment<'t>(&mut self, target: &EvaluationContext, text: &'t str) -> Option<(&'t str, &'t str)> {
        let scratch = Scratch::new(&mut self.targets, target, "", text);
        let found = body(scratch.db(), scratch.file());
        let [Stmt { kind: StmtKind::Assign { target: variable, .. }, .. }] = found.block.as_slice() else {
            return None;
        };
        let end = scratch.offset(found.range(*variable).end().into());
        let (variable, rest) = text.split_at_checked(end)?;
        let value = rest.trim_start().strip_prefix('=')?;
        self.is_analog(target, variable).then_some((variable, value))
    }

    /// Whether the code is a variable of the type `aio`.
    fn is_analog(&mut self, target: &EvaluationContext, variable: &str) -> bool {
        self.pure_expression(target, variable).is_ok_and(|(_, base)| base == Some(BaseType::Aio))
    }

    /// Compiled assignment. A number that is assigned to an `aio` variable is written to its signal.
    fn assignment(
        &mut self,
        target: &EvaluationContext,
        variable: &str,
        value: &str,
    ) -> Result<Fragment, EvaluationError> {
        if self.is_analog(target, variable) {
            // The value is an expression of its own, not a list of arguments.
            if self.pure_expression(target, value)?.1 != Some(BaseType::Num) {
                return Err(EvaluationError::from("the value of an `aio` is a `num`, such as `12.5`"));
            }
            return self.statements(target, &format!("{AIO_SET}({variable},{value})"));
        }
        let before = format!("{variable}=");
        let scratch = Scratch::new(&mut self.targets, target, &before, value);
        if let Some(fault) = scratch.fault() {
            return Err(EvaluationError::Code(fault));
        }
        match body(scratch.db(), scratch.file()).block.as_slice() {
            [stmt] if matches!(stmt.kind, StmtKind::Assign { .. }) => compile(&scratch, target),
            _ => Err(EvaluationError::from(format!("`{variable}` cannot be assigned to"))),
        }
    }
}

/// Input or output state without the link, because clients offer both for editing: `true` in `true (Io\\start)`.
fn state_of(shown: &str) -> Option<&str> {
    let (state, link) = shown.split_once(" (")?;
    link.ends_with(')').then_some(state)
}

const NO_EXPRESSION: &str = "write one expression";

const STATEMENT: &str = "a statement has no value to show; execute it in the debug console";

fn compile(scratch: &Scratch<'_>, target: &EvaluationContext) -> Result<Fragment, EvaluationError> {
    let scope = FragmentScope { image: &target.image, variables: &target.variables };
    let fragment = compile_statements(scratch.db(), target.project, scratch.file(), scope);
    fragment.map_err(|error| EvaluationError::from(error.limit.to_string()))
}
