//! Pictures of motion: the path of the tool centre point in three views; joints, speeds and distances over time.
//!
//! A picture is one SVG file without scripts or external references. Long recordings are thinned to visible details.

mod canvas;
mod charts;
mod colours;
mod heading;
mod in_force;
mod labels;
mod marks;
mod picture;
mod thinning;
mod ticks;
mod views;

pub use val3_motion::{MotionPhase, SpeedLimit};

pub use picture::{Deviation, DistanceSample, MoveLimits, MoveMark, Picture, PictureAxis, Sample};
pub use thinning::significant;

use canvas::Canvas;

impl Picture {
    /// Returns the picture as an SVG file.
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
