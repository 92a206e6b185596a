//! The debug adapter, through which clients of the Debug Adapter Protocol debug runs.
//!
//! [`MessageReader`] and [`MessageWriter`] move [`ProtocolMessage`]s over any stream. [`StandardRequest::parse`] decodes a
//! request. The types of [`protocol`] are generated from the schema of the specification.
//!
//! A [`Handshake`] handles the messages up to `launch` or `attach`. A [`DebugSession`] then handles the requests
//! between the cycles of the run. An [`AttachServer`] accepts clients that attach to a run. Clients of a port have to
//! send the [`Secret`] first. The caller provides the transports and the clock, and runs the controller.

mod assertions;
mod attach_server;
mod breakpoint_hits;
mod breakpoints;
mod capabilities;
mod cell_view;
mod client;
mod columns;
mod condition_text;
mod conventions;
mod debugged_run;
mod dispatch;
mod error;
mod failure;
mod frame;
mod handshake;
mod inspection;
mod live;
mod message;
mod moves;
mod notices;
pub mod protocol;
mod request;
mod requests;
mod screen_text;
mod secret;
mod series;
mod session;
mod session_start;
mod settings;
mod stop_event;
#[cfg(test)]
mod test_client;
mod user_page;
#[cfg(feature = "validate")]
pub mod validate;

pub use self::attach_server::AttachServer;
pub use self::client::{Client, Incoming, read_messages};
pub use self::debugged_run::DebuggedRun;
pub use self::error::{HeaderError, MessageError, ReadError, RequestError};
pub use self::frame::{BODY_LIMIT, HEADER_LIMIT, MessageReader, MessageWriter};
pub use self::handshake::{Handshake, HandshakeResult};
pub use self::message::{MessageContent, ProtocolMessage};
pub use self::protocol::{Response, StandardEvent, StandardRequest};
pub use self::requests::debug_requests_schema;
pub use self::secret::{SECRET, Secret};
pub use self::session::{DebugSession, NextAction, RunState, TimeEnd};
pub use self::session_start::SessionStart;
pub use self::settings::SessionSettings;
