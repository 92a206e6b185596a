//! Tests of the parser's public interface: trees, errors, recovery, and laws.
#![allow(clippy::unwrap_used, clippy::indexing_slicing, clippy::disallowed_methods, reason = "tests")]

mod faults_of_code;
mod faults_of_xml;
mod files;
mod hostile;
mod laws;
mod recovery;
mod show;
mod statements;
