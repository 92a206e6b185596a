//! Instructions in programs: the examples and results in the manual, executed on a controller.

#![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "a test may fail loudly")]

mod controller;
mod io;
mod motion;
mod reactions;
mod screen;
mod script;
mod tools;
mod trajectories;
