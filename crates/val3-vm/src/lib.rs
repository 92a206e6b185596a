//! Runs images: tasks, frames of programs, data, scheduling.
//!
//! The machine knows no clock, no input and no arm: instructions reach them through ports. One run of the same images
//! with the same answers of the ports gives the same steps.

mod arguments;
mod enter;
mod execute;
mod instance;
mod resume;
mod roster;
mod services;
mod task;
mod turn;
mod vm;

pub use instance::{Instance, InstanceId};
pub use task::{Frame, Rate, Task, TaskId, TaskState};
pub use turn::{Stop, Turn};
pub use vm::{Event, Vm};
