//! The virtual machine and the scheduler, with programs in the text form of images.
#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "tests")]

mod calls;
mod counts;
mod host;
mod libraries;
mod memory;
mod ports;
mod stops;
mod suspension;
mod synchronous;
mod task_control;
mod turns;
mod values;
mod waiting;
