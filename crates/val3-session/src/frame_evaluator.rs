//! Evaluation in the frames of a run: expressions, statements, assignments, conditions of breakpoints, completions.
//!
//! The database is that of the application when it was launched, so that later edits of the files change nothing.

mod completions;
mod condition;
mod effects;
mod evaluation;
mod log;
mod scratch;
mod target;

use std::iter;

use val3_analysis::body::{StmtKind, body};
use val3_analysis::infer::infer;
use val3_bytecode::Fragment;
use val3_compile::{compile_expression, compile_statements};
use val3_debug::{CompiledExpression, Format, Inside, LogMessage, Value, evaluate, expression_grant};
use val3_lang::types::BaseType;
use val3_machine::controller::Controller;
use val3_vm::{FragmentContext, FragmentEnd, Vm};

use crate::application::Application;

pub use completions::FrameCompletion;
pub use condition::LineCondition;
pub use evaluation::{Evaluation, EvaluationError};

use effects::effect;
use scratch::Scratch;
use target::{Target, Targets};

/// Lines that statements execute between two questions whether they may go on: about a millisecond.
const PORTION: u32 = 100_000;

/// Portions that statements may execute before they are ended: about half a second.
const PORTIONS: usize = 500;

/// Makes an expression a statement.
const PRINT: &str = "?";

/// The purpose of an evaluation, which decides on side effects.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Purpose {
    /// To show a value: an expression without side effects.
    Watch,
    /// To execute statements: calls, assignments, output.
    Execute,
}

/// Evaluates texts in the frames of a controller's tasks.
pub struct FrameEvaluator {
    targets: Targets,
}

impl FrameEvaluator {
    /// An evaluator for a controller that runs the image of `application`.
    #[must_use]
    pub fn new(application: Application) -> Self {
        Self { targets: Targets::new(application) }
    }

    /// Evaluates a text. Tasks, clock and arm rest during the evaluation, and no run-time error stops a task.
    ///
    /// # Errors
    /// The text is no code that may be evaluated for this purpose, or a run-time error ends it.
    pub fn evaluate(
        &mut self,
        controller: &mut Controller,
        context: FragmentContext,
        text: &str,
        how: (Purpose, Format),
    ) -> Result<Evaluation, EvaluationError> {
        self.evaluate_while(controller, context, text, how, &mut || true)
    }

    /// Evaluates a text as [`evaluate`](Self::evaluate) does, and asks about every millisecond whether statements
    /// `may_go_on`.
    ///
    /// # Errors
    /// As for [`evaluate`](Self::evaluate), or the statements may not go on.
    pub fn evaluate_while(
        &mut self,
        controller: &mut Controller,
        context: FragmentContext,
        text: &str,
        (purpose, format): (Purpose, Format),
        may_go_on: &mut dyn FnMut() -> bool,
    ) -> Result<Evaluation, EvaluationError> {
        let target = self.targets.of_context(&controller.vm, context)?;
        let is_expression = purpose == Purpose::Watch || self.is_expression(&target, text);
        let (fragment, has_effects) = if is_expression {
            let (fragment, effect) = self.expression(&target, text)?;
            match effect {
                Some(effect) if purpose == Purpose::Watch => return Err(effect.into()),
                effect => (fragment, effect.is_some()),
            }
        } else {
            (self.statements(&target, text)?, true)
        };
        let mut of_statements = iter::repeat_n(PORTION, PORTIONS).take_while(|_| may_go_on());
        let grants: &mut dyn Iterator<Item = u32> =
            if has_effects { &mut of_statements } else { &mut expression_grant() };
        let (end, events) = evaluate(controller, (&fragment, text.trim()), context, (grants, format));
        let done = Evaluation::new(events, has_effects);
        match end {
            FragmentEnd::Value(value) => Ok(Evaluation { value: Some(value), ..done }),
            FragmentEnd::Done => Ok(done),
            end => Err(EvaluationError::ended(&end, done)),
        }
    }

    /// Assigns the value of an expression to a variable, an element, a field or an output. Returns the new value.
    ///
    /// # Errors
    /// The texts are no target and value that fit, or a run-time error ends the assignment.
    pub fn assign(
        &mut self,
        controller: &mut Controller,
        context: FragmentContext,
        (target_text, value): (&str, &str),
        format: Format,
    ) -> Result<Value, EvaluationError> {
        let target = self.targets.of_context(&controller.vm, context)?;
        let fragment = self.assignment(&target, target_text, value).or_else(|error| match state_of(value) {
            Some(state) => self.assignment(&target, target_text, state),
            None => Err(error),
        })?;
        let (end, events) = evaluate(controller, (&fragment, target_text), context, (&mut expression_grant(), format));
        if end != FragmentEnd::Done {
            return Err(EvaluationError::ended(&end, Evaluation::new(events, true)));
        }
        let shown = self.evaluate(controller, context, target_text, (Purpose::Watch, format))?;
        shown.value.ok_or_else(|| EvaluationError::from("it has no value"))
    }

    /// Assigns to a value inside of another one, as [`assign`](Self::assign) does.
    ///
    /// # Errors
    /// As for [`assign`](Self::assign), or the value is computed from others.
    pub fn assign_child(
        &mut self,
        controller: &mut Controller,
        inside: &Inside,
        (name, value): (&str, &str),
        format: Format,
    ) -> Result<Value, EvaluationError> {
        let (context, path) = inside.expression(name).ok_or_else(|| {
            EvaluationError::from(format!("`{name}` is computed from other values and cannot be assigned to"))
        })?;
        let assigned = self.assign(controller, context, (&path, value), format)?;
        Ok(Value { name: name.to_owned(), ..assigned })
    }

    /// Compiles the condition of a breakpoint in a file.
    ///
    /// # Errors
    /// The text is no `bool` without side effects in the program of the file.
    pub fn condition(&mut self, vm: &Vm, file: &str, text: &str) -> Result<CompiledExpression, EvaluationError> {
        let target = self.targets.of_file(vm, file)?;
        let is_dio = self.pure_expression(&target, text)?.1 == Some(BaseType::Dio);
        let code = if is_dio { format!("({text})==true") } else { text.to_owned() };
        let (fragment, base) = self.pure_expression(&target, &code)?;
        match base {
            Some(BaseType::Bool) => Ok(CompiledExpression { text: text.to_owned(), fragment }),
            _ => Err(EvaluationError::from("a condition is a bool, such as `nCount>3`")),
        }
    }

    /// Compiles the message of a log point in a file: text with expressions in braces. `{{` and `}}` are braces.
    ///
    /// # Errors
    /// A brace is not closed, or an expression cannot be evaluated in the program of the file.
    pub fn log_message(&mut self, vm: &Vm, file: &str, text: &str) -> Result<LogMessage, EvaluationError> {
        let target = self.targets.of_file(vm, file)?;
        log::message(text, |code| {
            let (fragment, _) = self.pure_expression(&target, code)?;
            Ok(CompiledExpression { text: code.to_owned(), fragment })
        })
    }

    /// Whether a text is a single expression with a value.
    fn is_expression(&mut self, target: &Target, text: &str) -> bool {
        let scratch = Scratch::new(&mut self.targets, target, ("", text));
        let (db, file) = (scratch.db(), scratch.file());
        let inference = infer(db, target.project, file);
        let [stmt] = body(db, file).block.as_slice() else { return false };
        match &stmt.kind {
            StmtKind::Expr(id) => !inference.is_call_without_value(*id),
            _ => false,
        }
    }

    /// The code of an expression, and its effect if it has one.
    fn expression(&mut self, target: &Target, text: &str) -> Result<(Fragment, Option<String>), EvaluationError> {
        let scratch = Scratch::new(&mut self.targets, target, (PRINT, text));
        if let Some(fault) = scratch.fault() {
            let is_statement = !text.trim().is_empty() && self.statements(target, text).is_ok();
            return Err(if is_statement { STATEMENT.into() } else { EvaluationError::Code(fault) });
        }
        let (db, file) = (scratch.db(), scratch.file());
        let effect = match body(db, file).block.as_slice() {
            [stmt] => match stmt.kind {
                StmtKind::Print(id) => effect(db, (target.project, file), id),
                _ => return Err(EvaluationError::from(NO_EXPRESSION)),
            },
            _ => return Err(EvaluationError::from(NO_EXPRESSION)),
        };
        let scope = (&*target.image, target.variables.as_slice());
        let fragment = compile_expression(db, target.project, file, scope);
        Ok((fragment.map_err(|error| error.limit.to_string())?, effect))
    }

    /// The code and the type of an expression without side effects.
    fn pure_expression(
        &mut self,
        target: &Target,
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

    /// The code of statements.
    fn statements(&mut self, target: &Target, text: &str) -> Result<Fragment, EvaluationError> {
        let scratch = Scratch::new(&mut self.targets, target, ("", text));
        match scratch.fault() {
            Some(fault) => Err(EvaluationError::Code(fault)),
            None => compile(&scratch, target),
        }
    }

    /// The code of an assignment.
    fn assignment(&mut self, target: &Target, variable: &str, value: &str) -> Result<Fragment, EvaluationError> {
        let before = format!("{variable}=");
        let scratch = Scratch::new(&mut self.targets, target, (&before, value));
        if let Some(fault) = scratch.fault() {
            return Err(EvaluationError::Code(fault));
        }
        match body(scratch.db(), scratch.file()).block.as_slice() {
            [stmt] if matches!(stmt.kind, StmtKind::Assign { .. }) => compile(&scratch, target),
            _ => Err(EvaluationError::from(format!("`{variable}` cannot be assigned to"))),
        }
    }
}

/// The state of an input or output without its link, which clients offer to be edited: `true` of `true (Io\\start)`.
fn state_of(shown: &str) -> Option<&str> {
    let (state, link) = shown.split_once(" (")?;
    link.ends_with(')').then_some(state)
}

const NO_EXPRESSION: &str = "write one expression";

const STATEMENT: &str = "a statement has no value to show; execute it in the debug console";

fn compile(scratch: &Scratch<'_>, target: &Target) -> Result<Fragment, EvaluationError> {
    let scope = (&*target.image, target.variables.as_slice());
    let fragment = compile_statements(scratch.db(), target.project, scratch.file(), scope);
    fragment.map_err(|error| EvaluationError::from(error.limit.to_string()))
}
