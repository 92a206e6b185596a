//! Conditions and log messages of breakpoints: compiled once, evaluated at each hit.

use val3_bytecode::Fragment;
use val3_lang::call::Argument;
use val3_lang::fault::{Fault, Result};
use val3_lang::memory::{KindBase, Memory, Place};
use val3_lang::types::BaseType;
use val3_machine::controller::Controller;
use val3_vm::{FragmentContext, FragmentEnd, InstanceId, Vm};

use crate::evaluate::{end_message, evaluate, expression_grant};
use crate::values::{DisplayFormat, NamedFragment};

/// Expression that is compiled for the program of a breakpoint.
#[derive(Debug, Clone, PartialEq)]
pub struct CompiledExpression {
    /// Source of the expression.
    pub text: String,
    /// Compiled code. The value of a condition is a `bool`.
    pub fragment: Fragment,
}

/// Message of a log point.
#[derive(Debug, Clone, PartialEq)]
pub struct LogMessage {
    /// Parts in order.
    pub parts: Vec<LogPart>,
}

/// Part of a log point's message.
#[derive(Debug, Clone, PartialEq)]
pub enum LogPart {
    /// Literal text.
    Text(String),
    /// Expression to evaluate.
    Value(CompiledExpression),
}

impl CompiledExpression {
    /// Whether the condition is true in the context; the error is the reason why it has no value.
    pub(crate) fn holds(
        &self,
        controller: &mut Controller,
        context: FragmentContext,
    ) -> std::result::Result<bool, String> {
        let truth = |memory: &mut Memory, _: &_, argument| truth(memory, argument);
        match controller.evaluate(&self.fragment, context, &mut expression_grant(), truth).0 {
            FragmentEnd::Value(Ok(holds)) => Ok(holds),
            FragmentEnd::Value(Err(fault)) => Err(end_message(&FragmentEnd::<()>::Failed(fault))),
            end => Err(end_message(&end)),
        }
    }
}

/// Returns the context of conditions that belong to no program: the variables of the application.
#[must_use]
pub fn application_context(vm: &Vm) -> FragmentContext {
    FragmentContext::Instance(vm.space.loaded().next().map_or(InstanceId(0), |(instance, _)| instance))
}

/// Returns the place of a built-in value. A variable without an index is its first element.
fn place(memory: &Memory, argument: Argument) -> Result<Place> {
    match argument {
        Argument::Value(place, _) => Ok(place),
        Argument::View(view) => memory.element(view, 0),
        Argument::UserValue(_) | Argument::Slot(_) | Argument::Library(_) => Err(Fault::INTERPRETER),
    }
}

fn truth(memory: &Memory, argument: Argument) -> Result<bool> {
    Ok(memory.num(place(memory, argument)?, 0)? != 0.0)
}

/// Returns a string without quotation marks; `None` for an array of several values.
fn plain_text(memory: &Memory, argument: Argument) -> Result<Option<String>> {
    if let Argument::View(view) = argument
        && memory.len(view)? != 1
    {
        return Ok(None);
    }
    Ok(Some(memory.text(place(memory, argument)?)?.as_str().to_owned()))
}

impl LogMessage {
    /// Returns the message in the context. An expression without a value is replaced by the reason.
    pub(crate) fn text(&self, controller: &mut Controller, context: FragmentContext) -> String {
        let mut message = String::new();
        for part in &self.parts {
            match part {
                LogPart::Text(text) => message.push_str(text),
                LogPart::Value(value) => message.push_str(&value.shown(controller, context)),
            }
        }
        message
    }
}

impl CompiledExpression {
    fn shown(&self, controller: &mut Controller, context: FragmentContext) -> String {
        let is_string = matches!(
            self.fragment.value.as_ref().map(|value| &value.kind.base),
            Some(KindBase::Builtin(BaseType::String, _))
        );
        if is_string {
            let text = |memory: &mut Memory, _: &_, argument| plain_text(memory, argument);
            match controller.evaluate(&self.fragment, context, &mut expression_grant(), text).0 {
                FragmentEnd::Value(Ok(Some(text))) => return text,
                FragmentEnd::Value(Ok(None)) => {}
                FragmentEnd::Value(Err(fault)) => return end_message(&FragmentEnd::<()>::Failed(fault)),
                end => return end_message(&end),
            }
        }
        let code = NamedFragment { fragment: &self.fragment, text: &self.text };
        match evaluate(controller, code, context, &mut expression_grant(), DisplayFormat::default()).0 {
            FragmentEnd::Value(value) => value.shown,
            end => end_message(&end),
        }
    }
}
