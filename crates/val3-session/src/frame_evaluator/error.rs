//! Errors of evaluation.

use std::error::Error;
use std::fmt::{self, Display};

use val3_debug::end_message;
use val3_vm::FragmentEnd;

use super::Evaluation;
use crate::evaluate::CodeFault;

/// Why a text has not been evaluated to its end.
#[derive(Debug, Clone, PartialEq)]
pub enum EvaluationError {
    /// It is no code that can be evaluated here.
    Code(CodeFault),
    /// Its execution has ended early, after this.
    Ended {
        /// The reason, with the number of a run-time error.
        message: String,
        /// The part that was executed.
        done: Box<Evaluation>,
    },
}

impl EvaluationError {
    pub(super) fn ended<T>(end: &FragmentEnd<T>, done: Evaluation) -> Self {
        Self::Ended { message: end_message(end), done: Box::new(done) }
    }

    /// The part that was executed before the error.
    #[must_use]
    pub fn done(&self) -> Option<&Evaluation> {
        match self {
            Self::Code(_) => None,
            Self::Ended { done, .. } => Some(done),
        }
    }
}

impl From<String> for EvaluationError {
    fn from(message: String) -> Self {
        Self::Code(message.into())
    }
}

impl From<&str> for EvaluationError {
    fn from(message: &str) -> Self {
        message.to_owned().into()
    }
}

impl Display for EvaluationError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Code(fault) => f.write_str(fault.message()),
            Self::Ended { message, .. } => f.write_str(message),
        }
    }
}

impl Error for EvaluationError {}
