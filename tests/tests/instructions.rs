//! Instructions as programs use them: the examples and results of the manual, run on a controller.

#![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "a test may fail loudly")]

#[path = "instructions/controller.rs"]
mod controller;
#[path = "instructions/io.rs"]
mod io;
#[path = "instructions/motion.rs"]
mod motion;
#[path = "instructions/reactions.rs"]
mod reactions;
#[path = "instructions/screen.rs"]
mod screen;
#[path = "instructions/script.rs"]
mod script;
#[path = "instructions/tools.rs"]
mod tools;
#[path = "instructions/trajectories.rs"]
mod trajectories;
