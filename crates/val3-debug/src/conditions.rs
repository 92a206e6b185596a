//! Conditions and messages of breakpoints: compiled once, evaluated at each hit.

use val3_bytecode::Fragment;
use val3_lang::call::Argument;
use val3_lang::fault::{Fault, Result};
use val3_lang::memory::{KindBase, Memory};
use val3_lang::types::BaseType;
use val3_machine::controller::Controller;
use val3_vm::{FragmentContext, FragmentEnd};

use crate::evaluate::{LINES, end_message, evaluate};
use crate::values::Format;

/// An expression, compiled for the program that a breakpoint is in.
#[derive(Debug, Clone, PartialEq)]
pub struct CompiledExpression {
    /// The expression.
    pub text: String,
    /// Its code. The value of a condition is a `bool`.
    pub fragment: Fragment,
}

/// The message of a log point.
#[derive(Debug, Clone, PartialEq)]
pub struct LogMessage {
    /// Its parts in order.
    pub parts: Vec<LogPart>,
}

/// A part of the message of a log point.
#[derive(Debug, Clone, PartialEq)]
pub enum LogPart {
    /// Plain text.
    Text(String),
    /// The value of an expression.
    Value(CompiledExpression),
}

impl CompiledExpression {
    /// Whether it holds in a frame; otherwise the reason why it has no value.
    pub(crate) fn holds(
        &self,
        controller: &mut Controller,
        context: FragmentContext,
    ) -> std::result::Result<bool, String> {
        let truth = |memory: &mut Memory, _: &_, argument| truth(memory, argument);
        match controller.evaluate(&self.fragment, context, LINES, truth).0 {
            FragmentEnd::Value(Ok(holds)) => Ok(holds),
            FragmentEnd::Value(Err(fault)) => Err(end_message(&FragmentEnd::<()>::Failed(fault))),
            end => Err(end_message(&end)),
        }
    }
}

fn truth(memory: &Memory, argument: Argument) -> Result<bool> {
    match argument {
        Argument::Value(place, BaseType::Bool) => Ok(memory.num(place, 0)? != 0.0),
        _ => Err(Fault::INTERPRETER),
    }
}

impl LogMessage {
    /// The message in a frame. An expression without a value is replaced by the reason.
    pub(crate) fn text(&self, controller: &mut Controller, context: FragmentContext) -> String {
        let part = |part: &LogPart| match part {
            LogPart::Text(text) => text.clone(),
            LogPart::Value(value) => value.shown(controller, context),
        };
        self.parts.iter().map(part).collect()
    }
}

impl CompiledExpression {
    fn shown(&self, controller: &mut Controller, context: FragmentContext) -> String {
        let is_string = matches!(
            self.fragment.value.as_ref().map(|value| &value.kind.base),
            Some(KindBase::Builtin(BaseType::String, _))
        );
        if is_string {
            let text = |memory: &mut Memory, _: &_, argument| match argument {
                Argument::Value(place, _) => memory.text(place).map(|text| text.as_str().to_owned()),
                _ => Err(Fault::INTERPRETER),
            };
            return match controller.evaluate(&self.fragment, context, LINES, text).0 {
                FragmentEnd::Value(Ok(text)) => text,
                FragmentEnd::Value(Err(fault)) => end_message(&FragmentEnd::<()>::Failed(fault)),
                end => end_message(&end),
            };
        }
        match evaluate(controller, (&self.fragment, &self.text), context, (LINES, Format::default())).0 {
            FragmentEnd::Value(value) => value.shown,
            end => end_message(&end),
        }
    }
}
