//! Power, modes, speed, versions, users and dates of the controller (4.3, 8).

/// The state of the controller.
pub trait Robot {}
