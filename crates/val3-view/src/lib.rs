//! Messages of a run for the pages that display and operate it (docs/src/view.md).
//!
//! The content of a page at any time is determined by the messages up to that time. The crate contains no network code:
//! its caller passes each cycle to a [`Feed`] and transmits the messages.

mod arm;
mod cell;
mod code;
mod commands;
mod configuration;
mod feed;
mod lines;
mod motion;
mod positions;
mod programs;
mod reach;
mod samples;
mod scene;
mod signals;
mod state;
mod units;
mod user_page;
pub mod wire;

pub use commands::{Operator, response};
pub use feed::{Feed, ViewerMessage};
pub use lines::{FileReader, code_of_line};
pub use scene::scene;
pub use signals::direction;
pub use user_page::user_page;
pub use wire::CommandError;

use val3_geometry::{IsometryMatrix3, Trsf};

/// Converts a pose to x, y, z in mm and rx, ry, rz in degrees, like the fields of a `trsf`.
#[must_use]
pub fn coordinates(position: &IsometryMatrix3<f64>) -> [f64; 6] {
    numbers(&Trsf::from(*position))
}

pub(crate) fn numbers(&Trsf { x, y, z, rx, ry, rz }: &Trsf) -> [f64; 6] {
    [x, y, z, rx, ry, rz]
}
