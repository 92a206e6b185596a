//! The virtual controller: tasks, inputs and outputs, screen, files and clock, one tick at a time.

pub mod arm;
pub mod blend_ends;
pub mod controller;
pub mod controller_state;
pub mod devices;
pub mod event;
pub mod files;
pub mod inputs;
pub mod io;
mod missing_instruction;
mod run_status;
pub mod screen;
pub mod script;
pub mod shapes;
pub mod sio;
mod string_bytes;

pub use missing_instruction::missing_instruction;
