//! Digital and analog inputs and outputs (3.5, 3.6, 5.7).

mod bus;
mod declarations;
mod outside;
mod program;
mod signal;
mod status;
mod table;

pub use bus::DeviceFault;
pub use declarations::NoSignal;
pub use outside::Forcing;
pub use signal::{Direction, Signal, SignalKind, SignalRange};
pub use status::{IoError, IoStatus, SignalFault};
pub use table::{IoChange, IoTable, LinkId, SignalId};
