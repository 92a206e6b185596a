//! Transport of bytes: one thread reads frames and another writes them, so that neither direction blocks the other.

mod frame;
mod intake;
mod pump;

pub(crate) use frame::frame;
pub(crate) use intake::{Intake, read};
pub(crate) use pump::{Pump, PumpWriter};
