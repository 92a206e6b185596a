//! Structure of the sources and documents: the dependencies of each crate, and things that may be written in only one
//! place.

mod address_once;
mod command;
mod dap_types;
mod decisions;
mod document_paths;
mod files_once;
mod import_circles;
mod language_once;
mod layers;
mod line_ends;
mod oldest_compiler;
mod supply_chain;
