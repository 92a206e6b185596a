//! Sessions: an application from its files to a controller that executes it, and evaluation of code in it.
//!
//! The command line, the debug adapter, tests and benchmarks open applications here, so that all of them use the same
//! controller. [`Application`] finds, reads and compiles an application and opens its controller with
//! [`ControllerSettings`]. [`Pace`] computes the waits between cycles. [`Evaluator`] executes code in an application,
//! and [`FrameEvaluator`] in the stack frames of a debugged run. The crate does not use arguments, terminals, threads
//! or the real clock.

mod add_on_programs;
mod application;
mod arm;
mod cell;
mod cell_profiles;
mod code_lines;
mod connection;
mod controller;
mod error;
pub mod evaluate;
mod frame_evaluator;
mod grants;
mod io_library;
mod json_fault;
mod libraries;
mod media;
mod pace;
mod pages;
mod readable;
mod same_file;
mod settings;
mod shapes;
mod stand_ins;
mod surroundings;

pub use application::Application;
pub use arm::{ArmFile, request_arm};
pub use cell_profiles::{CellProfile, ProfileRights};
pub use code_lines::CodeLine;
pub use connection::{Connection, Tape};
pub use error::SessionError;
pub use evaluate::{CodeFault, EvaluationOutput, Evaluator, Listener};
pub use frame_evaluator::{
    Evaluation, EvaluationError, ExecutionRequests, FrameCompletion, FrameEvaluator, LineCondition, LoadRequest,
    Purpose, ReplaceFault,
};
pub use json_fault::json_fault;
pub use pace::{Delay, Pace};
pub use same_file::is_same_file;
pub use settings::{ControllerSettings, LINE_COST, PathRoot, line_cost};
pub use stand_ins::StandInFault;
pub use surroundings::CellChoice;
pub use val3_compile::CodeForm;
