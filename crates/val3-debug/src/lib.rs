//! Debugger for a controller: breakpoints, steps, run-time errors, stack frames and values.
//!
//! The crate contains no protocol and reads no clock. The caller calls [`Debugger::advance`], waits if the run follows
//! real time, and reports the stops.

mod arguments;
mod backwards;
mod breakpoints;
mod calls;
mod causes;
mod conditions;
mod contacts;
mod data_breakpoints;
mod debugger;
mod errors;
mod evaluate;
mod frames;
mod goto;
mod history;
mod lifetime_search;
mod lifetimes;
mod motion;
mod pause;
mod program_breakpoints;
mod reads;
mod replace;
mod replay;
mod restart;
mod skipped_code;
mod step;
mod step_in;
mod travel;
mod unlinked;
mod values;
mod variable_filter;
mod watched;
mod writes;

pub use arguments::{FrameArgument, arguments};
pub use backwards::{Goal, Watcher};
pub use breakpoints::{
    Breakpoint, BreakpointId, ConditionFault, HitCondition, InvalidHitCondition, LoggedMessage, Placed,
};
pub use calls::{Execution, ExecutionEnd, ExecutionLimits};
pub use causes::causes;
pub use conditions::{CompiledExpression, LogMessage, LogPart, application_context};
pub use contacts::Contact;
pub use data_breakpoints::{DataAccess, DataBreakpoint, DataChange, DataStop};
pub use debugger::{AdvanceResult, Debugger, Stop};
pub use errors::{StopErrors, handler};
pub use evaluate::{end_message, evaluate, expression_grant};
pub use frames::{TaskFrame, frames};
pub use goto::{GotoFault, GotoTarget};
pub use history::{HistoryExtent, Moment, PastLimits};
pub use program_breakpoints::{PlacedProgram, ProgramBreakpoint, ProgramName};
pub use restart::RestartFault;
pub use skipped_code::{InvalidSkipPattern, SkipPattern};
pub use step::StepKind;
pub use step_in::StepInTarget;
pub use travel::MotionStop;
pub use values::{
    DebugValue, DisplayFormat, Inside, NamedFragment, Scope, ScopeKind, count, data, row_of_data, scopes,
    string_of_data, subscript, values,
};
pub use variable_filter::{InvalidVariableFilter, VariableFilter};
pub use watched::{DataForm, DataTable, NumberSeries, TableRow, WatchedData};
pub use writes::{DataWrite, DataWrites, InitialValue, WriteLimits};
