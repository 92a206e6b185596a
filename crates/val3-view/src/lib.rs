//! A run as messages for the pages that show and operate it (docs/src/view.md).
//!
//! Everything that a page shows follows from the messages up to that time. The crate knows no connection: its caller hands
//! over each cycle to a [`Feed`], and passes the messages on.

mod arm;
mod commands;
mod feed;
mod message;
mod motion;
mod pace;
mod positions;
mod samples;
mod scene;
mod signals;
mod state;
mod user_page;

pub use commands::{CommandError, Operator};
pub use feed::Feed;
pub use message::Message;
pub use pace::Speed;
pub use scene::scene;
pub use signals::{direction, level};
pub use user_page::user_page;

use val3_geometry::{IsometryMatrix3, Trsf};

/// x, y, z in mm, rx, ry, rz in degrees, as the fields of a `trsf`.
#[must_use]
pub fn coordinates(position: &IsometryMatrix3<f64>) -> [f64; 6] {
    numbers(&Trsf::from(*position))
}

pub(crate) fn numbers(&Trsf { x, y, z, rx, ry, rz }: &Trsf) -> [f64; 6] {
    [x, y, z, rx, ry, rz]
}
