//! SOAP interface of the virtual controller.
//!
//! A [`Service`] receives the requests of `val3-soap` between the cycles of a run and executes them on its controller:
//! sessions with the rights of profiles, units, and the faults of a real controller. Connections and the clock belong
//! to the binary.
//!
//! No specification of the interface is public; its behaviour is derived from clients. All inferred answers are in
//! `inferred.rs`.

mod accounts;
mod applications;
mod context;
mod debugging;
mod inferred;
mod kinematics;
mod lines;
mod modified;
mod moves;
mod projects;
mod requests;
mod service;
mod sessions;
mod signals;
mod tasks;
#[cfg(test)]
mod tests;
mod units;

pub use accounts::Accounts;
pub use context::ServiceTarget;
pub use service::{Service, ServiceAnswer, ServiceCall};
