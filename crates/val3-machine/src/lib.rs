//! The virtual controller: tasks, inputs and outputs, screen, files and clock, one tick at a time.

pub mod files;
pub mod sio;
mod string_bytes;
