//! The bytes: frames are read on one thread and written on another, so that neither side ever holds up the other.

mod frame;
mod intake;
mod pump;

pub(crate) use frame::frame;
pub(crate) use intake::{Intake, read};
pub(crate) use pump::{Pump, PumpWriter};
