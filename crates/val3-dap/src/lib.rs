//! The Debug Adapter Protocol. The types of [`protocol`] are generated from the schema of the specification.

pub mod protocol;

pub use self::protocol::{Event, Request, Response};
