//! Attacks on a server, and viewers that see the same.

mod attacks;
mod client;
mod viewers;
