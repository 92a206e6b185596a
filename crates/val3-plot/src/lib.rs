//! A picture of motion: the path of the tool centre point from three sides, joints and speeds over time.
//!
//! The picture is one SVG without scripts or outside references. Long recordings are thinned to what can be seen.

mod canvas;
mod charts;
mod labels;
mod thinning;
mod ticks;
mod views;

pub use val3_motion::Phase;

pub use thinning::significant;

use canvas::Canvas;

/// The data of a picture of a run.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Picture {
    /// Its title, such as the name of the application.
    pub title: String,
    /// The model of the arm.
    pub arm: String,
    /// The axes of the arm.
    pub axes: Vec<Axis>,
    /// The motion, in the order of time.
    pub samples: Vec<Sample>,
    /// The moves, in the order in which they were recorded.
    pub moves: Vec<Mark>,
    /// A recorded motion with which this one is compared; empty without one.
    pub reference: Vec<Sample>,
    /// The place at which the motion is the furthest away from the recorded one.
    pub deviation: Option<Deviation>,
}

/// A place of one motion and the nearest place of another.
#[derive(Clone, Debug, PartialEq)]
pub struct Deviation {
    /// The distance: `12.3 mm`.
    pub label: String,
    /// The place in world, in mm.
    pub at: [f64; 3],
    /// The nearest place in world, in mm.
    pub nearest: [f64; 3],
    /// When the arm was at the place, in seconds.
    pub t: f64,
}

/// An axis of the arm: degrees, or millimetres for a stroke.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// Whether it is a linear axis.
    pub is_stroke: bool,
    /// Lower software limit.
    pub min: f64,
    /// Upper software limit.
    pub max: f64,
    /// Nominal speed, per second.
    pub nominal_speed: f64,
}

/// The arm at one time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// Seconds.
    pub t: f64,
    /// Position of each axis.
    pub joints: [f64; 6],
    /// The tool centre point in world, in mm.
    pub position: [f64; 3],
    /// Speed of the tool centre point, in mm/s.
    pub speed: f64,
    /// The kind of motion.
    pub phase: Phase,
}

/// A move.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mark {
    /// Program and line: `start:12`.
    pub label: String,
    /// The tool centre point at the destination, in world, in mm.
    pub target: [f64; 3],
    /// Where the blend around the destination begins.
    pub leave: Option<[f64; 3]>,
    /// Where it ends.
    pub reach: Option<[f64; 3]>,
    /// When the arm began with the move, in seconds.
    pub started: Option<f64>,
}

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

/// Draws a mark at a point.
type DrawMark = fn(&mut Canvas, [f64; 2]);

/// The colour of a phase.
fn colour(phase: Phase) -> &'static str {
    PHASES.iter().find(|(known, ..)| *known == phase).map_or("#000000", |(_, colour, _)| colour)
}

impl Picture {
    /// The picture as the text of an SVG file.
    #[must_use]
    pub fn to_svg(&self) -> String {
        let mut canvas = Canvas::default();
        self.heading(&mut canvas);
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

    /// Title and legend.
    fn heading(&self, canvas: &mut Canvas) {
        canvas.text([40.0, 34.0], "title", &self.title);
        let moves = if self.moves.len() == 1 { "1 move".to_owned() } else { format!("{} moves", self.moves.len()) };
        let times = format!("{:.3} s", length(&self.samples));
        let times = match self.reference.is_empty() {
            true => times,
            false => format!("{times}, recorded {:.3} s", length(&self.reference)),
        };
        canvas.text([40.0, 56.0], "small", &format!("{}, {moves}, {times}", self.arm));
        let used = |phase: &Phase| *phase != Phase::Waiting && self.samples.iter().any(|sample| sample.phase == *phase);
        let mut x = 420.0;
        for (_, colour, name) in PHASES.iter().filter(|(phase, ..)| used(phase)) {
            canvas.line([x, 30.0], [x + 26.0, 30.0], &format!("stroke:{colour};stroke-width:3"));
            canvas.text([x + 32.0, 34.0], "small", name);
            x += 50.0 + 7.5 * name.len() as f64;
        }
        if !self.reference.is_empty() {
            canvas.line([x, 30.0], [x + 26.0, 30.0], REFERENCE);
            canvas.text([x + 38.0, 34.0], "small", "recorded");
        }
        let marks: [(&str, DrawMark); 4] =
            [("start", views::start), ("target", views::target), ("leave", views::leave), ("reach", views::reach)];
        let mut x = 420.0;
        for (name, draw) in marks {
            draw(canvas, [x + 13.0, 52.0]);
            canvas.text([x + 32.0, 56.0], "small", name);
            x += 50.0 + 7.5 * name.len() as f64;
        }
        if let Some(deviation) = &self.deviation {
            views::deviation(canvas, [x + 13.0, 52.0]);
            canvas.text([x + 32.0, 56.0], "small", &format!("largest deviation: {}", deviation.label));
        }
    }
}

/// Seconds from the first sample to the last one.
fn length(samples: &[Sample]) -> f64 {
    samples.first().zip(samples.last()).map_or(0.0, |(first, last)| last.t - first.t)
}

#[cfg(test)]
mod tests;
