//! Virtual machine for images: tasks, stack frames, data, scheduling.
//!
//! This crate contains no clock, input or arm: instructions access them through ports. Runs of the same images with the
//! same results of the ports execute the same operations.

mod arithmetic;
mod calls;
mod counts;
mod create_task;
mod data_watch;
mod ends;
mod enter;
mod evaluate;
mod execute;
mod failed_access;
mod guards;
mod hit_counters;
mod host;
mod instance;
mod instruction;
mod interface;
mod libraries;
mod library_references;
mod operands;
mod registers;
mod replace;
mod roster;
mod schedule;
mod services;
mod space;
mod stacked_fragment;
mod stops;
mod task;
mod turn;
mod turn_context;
mod values;
mod vm;

pub use counts::LineCounts;
pub use data_watch::{BegunLine, DataWatch, FrameOwner, WatchedValue};
pub use ends::{CycleEnd, TurnEnd};
pub use evaluate::{FragmentContext, FragmentEnd};
pub use failed_access::FailedAccess;
pub use guards::{GuardedOp, StopGuard, StopReason};
pub use hit_counters::CounterId;
pub use host::{Host, LibraryOp, LibraryRequest, LoadedLibrary};
pub use instance::{Imported, Instance, InstanceId, ProgramId};
pub use replace::{LineReplacement, MovedCode};
pub use schedule::{CYCLE, CycleWatch, Schedule};
pub use space::Space;
pub use task::{Base, Frame, Rate, Task, TaskState, Thread};
pub use turn::{Grant, TurnReport};
pub use vm::Vm;
