//! The structure of the sources and documents: what each crate may use, and what is written in one place only.

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
