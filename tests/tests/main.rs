//! Tests with complete cells. They are one binary, because each binary contains the entire analysis and runtime.

mod assists;
mod ci_recipes;
mod completion;
mod data_edits;
mod distances;
mod everywhere;
mod examples;
mod execution;
mod fixes;
mod fuzz_corpus;
mod install;
mod instructions;
mod mutations;
mod release_notes;
mod rename;
#[cfg(unix)]
mod scratch;
mod signature;
