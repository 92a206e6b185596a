//! Small applications under a debugger.
#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "a test may fail loudly")]

mod control;
mod data;
mod data_laws;
mod debugger;
mod errors;
mod local_laws;
mod motion;
mod past;
mod programs;
mod step_in;
mod values;
mod writes;
