//! Definition of VAL 3, the only one in the project.
//!
//! Types, instructions, operators, enumerations, run-time errors and versions as data for the analysis, the editor
//! features and the runtime. No other crate contains an instruction name or a built-in field, or the number of a
//! run-time error.

pub mod data_path;
mod declare;

pub mod add_on;
pub mod arguments;
pub mod builtins;
pub mod call;
pub mod components;
pub mod enumerations;
pub mod fault;
pub mod file_pages;
pub mod files;
pub mod foreign_names;
mod geometry_parameters;
pub mod glossary;
mod gripper;
pub mod instruction;
pub mod instructions;
pub mod io_paths;
pub mod keys;
pub mod keywords;
pub mod library_errors;
pub mod log_messages;
pub mod memory;
pub mod motion;
mod moves;
pub mod number_functions;
pub mod operators;
pub mod page;
pub mod ports;
pub mod references;
pub mod replacements;
pub mod results;
pub mod runtime_errors;
pub mod statements;
pub mod suggest;
pub mod tasks;
pub mod test_names;
#[cfg(test)]
mod testing;
pub mod types;
pub mod values;
pub mod versions;
