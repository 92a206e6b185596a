//! Compiler from typed programs to images: the bridge between analysis and run time.
//!
//! The analysis provides its results (items, bodies, types, the form of each call), and nothing is inferred again. Each
//! part of a program has a module: its frame, names and places, expressions, conditions, assignments, statements and
//! calls. The data of a project are read from its files with their initial values.

mod closings;
mod code;
mod code_form;
mod counting;
mod data;
mod emitter;
mod error;
mod expressions;
mod fragment;
mod frame;
mod io_library;
mod kinds;
mod layout;
mod location;
mod pool;
mod program;
mod project;
mod statements;
mod unit;
mod variables;

pub use code_form::CodeForm;
pub use error::{CompileError, CompileLimit};
pub use fragment::{FragmentScope, compile_expression, compile_statements};
pub use layout::{FrameLayout, LayoutRequest, ReplacedLine};
pub use project::{compile, compile_as, compile_with_layout};
