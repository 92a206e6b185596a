//! The debug adapter: clients of the Debug Adapter Protocol debug runs.
//!
//! [`MessageReader`] and [`MessageWriter`] move [`ProtocolMessage`]s over any stream. [`Request::parse`] makes a typed
//! request of a message. The types of [`protocol`] are generated from the schema of the specification.
//!
//! A [`Greeting`] waits until a client says what to run. A [`DebugSession`] then attends to the client between the cycles
//! of the run; a [`Reception`] lets clients attach to a run and leave it. Clients of a port have to send its [`Secret`]
//! first. This crate knows neither transports nor clocks, and it does not run the controller: its caller does.

mod assertions;
mod breakpoints;
mod capabilities;
mod cell_view;
mod client;
mod conventions;
mod custom;
mod error;
mod frame;
mod greeting;
mod inspection;
mod live;
mod message;
mod notices;
pub mod protocol;
mod reception;
mod secret;
mod session;
mod settings;
#[cfg(feature = "validate")]
pub mod validate;

pub use self::client::{Client, Incoming, read_messages};
pub use self::error::{FrameError, MessageError, ReadError, RequestError};
pub use self::frame::{BODY_LIMIT, HEADER_LIMIT, MessageReader, MessageWriter};
pub use self::greeting::{Greeting, SessionStart, Wish};
pub use self::message::{Content, ProtocolMessage};
pub use self::protocol::{Event, Request, Response};
pub use self::reception::Reception;
pub use self::secret::{SECRET, Secret};
pub use self::session::{DebugSession, Demand, RunState, Target};
pub use self::settings::SessionSettings;
