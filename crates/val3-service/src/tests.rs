//! Requests to a controller with a small application.

mod applications;
mod arms;
mod client;
mod data;
mod debugging;
mod documents;
mod events;
mod goto;
mod kinematics;
mod moves;
mod replace;
mod rights;
mod sessions;
mod signals;
