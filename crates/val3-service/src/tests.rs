//! Requests to a controller with a small application.

mod arms;
mod client;
mod data;
mod debugging;
mod kinematics;
mod moves;
mod rights;
mod sessions;
mod signals;
