//! Structure of the sources and documents: the dependencies of each crate, and facts that may be stated in only one
//! file.

mod address_once;
mod command;
mod dap_types;
mod decisions;
mod document_paths;
mod files_once;
mod functions;
mod import_circles;
mod language_once;
mod layers;
mod line_ends;
mod modules;
mod oldest_compiler;
mod supply_chain;
