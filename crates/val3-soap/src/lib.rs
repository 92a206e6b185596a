//! Messages of the SOAP interface of CS8 and CS9 controllers: requests, answers and faults as typed structs.
//!
//! A message is a [`Envelope`]: a SOAP version, a session and a body. A request's body is a [`SoapRequest`], an
//! answer's body a [`SoapAnswer`] or a [`SoapFault`]. Each operation is one file, and [`operations`] lists all operations.
//!
//! Names and types come from public clients' stubs. The folder `tests/samples` contains a request and an answer
//! for each operation.

mod base64_value;
mod document;
mod envelope;
mod error;
mod fault;
pub mod operations;
mod server;
mod structure;
mod value;
mod version;

pub mod multipart;
pub mod v0;
pub mod v1;
pub mod v2;
pub mod v3;

pub use base64_value::Binary;
pub use document::{SoapAttribute, SoapElement};
pub use envelope::{Envelope, SessionHeader};
pub use error::SoapError;
pub use fault::{Culprit, ExceptionCode, ServerException, SoapFault};
pub use operations::{SoapAnswer, SoapRequest};
pub use server::SoapServer;
pub use value::{Empty, Operation, SoapValue};
pub use version::SoapVersion;
