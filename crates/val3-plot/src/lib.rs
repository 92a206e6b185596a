//! A picture of motion: the path of the tool centre point from three sides, joints and speeds over time.
//!
//! The picture is one SVG without scripts or outside references. Long recordings are thinned to what can be seen.

mod canvas;
mod charts;
mod heading;
mod in_force;
mod labels;
mod marks;
mod picture;
mod thinning;
mod ticks;
mod views;

pub use val3_motion::Phase;

pub use picture::{Axis, Deviation, Mark, MoveLimits, Picture, Sample};
pub use thinning::significant;

use canvas::Canvas;

/// The phases with their colours, which people with any kind of colour vision tell apart (Okabe and Ito), and their names.
const PHASES: [(Phase, &str, &str); 7] = [
    (Phase::Nominal, "#0072b2", "path of a move"),
    (Phase::Blend, "#e69f00", "blend"),
    (Phase::Connection, "#cc79a7", "connection move"),
    (Phase::Alter, "#009e73", "altered"),
    (Phase::Compliant, "#56b4e9", "compliant"),
    (Phase::Stopping, "#d55e00", "stopping"),
    (Phase::Waiting, "#999999", "waiting"),
];

/// A recorded motion is a wide band below the present one, so that both can be seen where they are the same.
const REFERENCE: &str = "stroke:#c9c9c9;stroke-width:7;stroke-linejoin:round;stroke-linecap:round";

/// The colour of a phase.
fn colour(phase: Phase) -> &'static str {
    PHASES.iter().find(|(known, ..)| *known == phase).map_or("#000000", |(_, colour, _)| colour)
}

impl Picture {
    /// The picture as the text of an SVG file.
    #[must_use]
    pub fn to_svg(&self) -> String {
        let mut canvas = Canvas::default();
        heading::draw(self, &mut canvas);
        let mut below = views::draw(self, &mut canvas, 70.0);
        if self.moves.is_empty() {
            canvas.text([40.0, below + 24.0], "small", "The program has recorded no move.");
            below += 24.0;
        }
        if self.samples.len() > 1 || self.reference.len() > 1 {
            below = charts::draw(self, &mut canvas, below + 30.0);
        }
        let description = format!("Path of the tool centre point, joints and speeds of a {}", self.arm);
        canvas.finish(below + 20.0, &self.title, &description)
    }
}

#[cfg(test)]
mod tests;
