//! Runs a controller under control: breakpoints, steps, run-time errors, and the frames and values of its tasks.
//!
//! The crate knows no protocol and no clock. Its caller lets a [`Debugger`] advance, waits for the real time where the run
//! follows it, and passes on what stops.

mod backwards;
mod breakpoints;
mod conditions;
mod debugger;
mod evaluate;
mod frames;
mod history;
mod motion;
mod step;
mod values;

pub use breakpoints::{
    Breakpoint, BreakpointId, ConditionFault, HitCondition, InvalidHitCondition, LoggedMessage, Placed,
};
pub use conditions::{CompiledExpression, LogMessage, LogPart};
pub use debugger::{Debugger, Errors, Progress, Stop};
pub use evaluate::{Location, end_message, evaluate, locate};
pub use frames::{TaskFrame, frames};
pub use history::Moment;
pub use motion::MotionStop;
pub use step::StepKind;
pub use values::{Format, Inside, Scope, ScopeKind, Value, count, data, scopes, values};
