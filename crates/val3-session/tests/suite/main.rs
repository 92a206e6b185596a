//! Sessions of small applications.
#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "a test may fail loudly")]

mod breakpoints;
mod code_form;
mod frames;
mod random_texts;
mod replace;
mod stepping;
mod stopped;
mod values;
