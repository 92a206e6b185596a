//! The parser from outside: its trees, its messages, its recovery, and the laws it keeps.
#![allow(clippy::unwrap_used, clippy::indexing_slicing, clippy::disallowed_methods, reason = "tests")]

mod faults_of_code;
mod faults_of_xml;
mod files;
mod hostile;
mod laws;
mod recovery;
mod show;
mod statements;
