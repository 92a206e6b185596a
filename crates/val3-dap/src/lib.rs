//! The Debug Adapter Protocol: messages, their types, and the frames in which they are sent.
//!
//! [`MessageReader`] and [`MessageWriter`] move [`ProtocolMessage`]s over any stream. [`Request::parse`] makes a typed
//! request of a message. The types of [`protocol`] are generated from the schema of the specification. This crate knows
//! neither VAL 3 nor a transport.

mod error;
mod frame;
mod message;
pub mod protocol;
#[cfg(feature = "validate")]
pub mod validate;

pub use self::error::{FrameError, MessageError, ReadError, RequestError};
pub use self::frame::{BODY_LIMIT, HEADER_LIMIT, MessageReader, MessageWriter};
pub use self::message::{Content, ProtocolMessage};
pub use self::protocol::{Event, Request, Response};
