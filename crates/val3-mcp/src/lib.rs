//! Tools of VAL 3 for language models, over the Model Context Protocol on standard input and output.
//!
//! Each file in `tools` is a tool: its arguments, its description, and a function that returns an [`answer::Answer`].
//! Tools that check or execute programs start a command of `val3` through [`Commands`], so that resource limits,
//! cancellation and crashes of a command do not affect the server. Only `server` depends on the protocol.

mod answer;
mod arguments;
mod changes;
mod command;
mod cut;
mod projects;
mod prompts;
mod refusal;
mod report;
mod resources;
mod roots;
mod schema;
mod server;
mod tool;
mod tools;
mod written;

#[cfg(test)]
mod testing;

pub use command::{CommandEnd, CommandLimits, CommandOutput, CommandRequest, Commands};
pub use refusal::Refusal;
pub use roots::Roots;
pub use server::{ServerOptions, serve};
