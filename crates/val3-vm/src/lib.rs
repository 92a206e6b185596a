//! Runs images: tasks, frames of programs, data, scheduling.
//!
//! The machine knows no clock, no input and no arm: instructions reach them through ports. One run of the same images
//! with the same answers of the ports gives the same steps.

mod arguments;
mod arithmetic;
mod calls;
mod enter;
mod execute;
mod host;
mod instance;
mod instruction;
mod interface;
mod libraries;
mod machine;
mod resume;
mod roster;
mod schedule;
mod services;
mod space;
mod task;
mod turn;
mod usage;
mod values;
mod vm;
mod window;

pub use host::{Host, LibraryOp, Loaded};
pub use instance::{Imported, Instance, InstanceId};
pub use schedule::{CYCLE, Cycle, Schedule};
pub use space::Space;
pub use task::{Base, Frame, Rate, Task, TaskState, Thread};
pub use turn::{Grant, Stop, Turn};
pub use vm::Vm;
