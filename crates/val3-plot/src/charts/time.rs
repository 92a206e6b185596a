//! Time axis.

use crate::canvas::{Canvas, WIDTH};
use crate::{Picture, ticks};

/// Left and right end of the charts.
pub(super) const LEFT: f64 = 120.0;
pub(super) const RIGHT: f64 = WIDTH - 40.0;

/// Minimum distance of move labels in pixels.
const APART: f64 = 13.0;

/// The time axis.
pub(super) struct Time {
    from: f64,
    to: f64,
    scale: f64,
}

impl Time {
    /// Creates the axis for the time of the motion and the recorded motion.
    pub(super) fn of(picture: &Picture) -> Self {
        let ends = [&picture.samples, &picture.reference].map(|samples| samples.first().zip(samples.last()));
        let ends = ends.into_iter().flatten().map(|(first, last)| [first.t, last.t]);
        let ends = ends.reduce(|[from, to], [other_from, other_to]| [from.min(other_from), to.max(other_to)]);
        let [from, to] = ends.unwrap_or([0.0, 1.0]);
        Self { from, to, scale: (RIGHT - LEFT) / (to - from).max(0.004) }
    }

    /// Returns the x coordinate of a time in seconds.
    pub(super) fn x(&self, t: f64) -> f64 {
        LEFT + (t - self.from) * self.scale
    }

    /// Whether the axis contains a time in seconds.
    pub(super) fn contains(&self, t: f64) -> bool {
        (self.from..=self.to).contains(&t)
    }

    /// Returns the x coordinate of a time in seconds, clipped to the charts.
    pub(super) fn x_within(&self, t: f64) -> f64 {
        self.x(t).clamp(LEFT, RIGHT)
    }

    /// Draws the numbers of the axis.
    pub(super) fn axis(&self, canvas: &mut Canvas, y: f64) {
        let step = ticks::step(self.scale, 80.0);
        for t in ticks::multiples(step, [self.from, self.to]) {
            canvas.text([self.x(t), y + 14.0], "tick centre", &ticks::shown(t, step));
        }
        canvas.text([LEFT - 12.0, y + 14.0], "small right", "time (s)");
    }

    /// Draws the grid lines across a chart.
    pub(super) fn grid(&self, canvas: &mut Canvas, [top, bottom]: [f64; 2]) {
        let step = ticks::step(self.scale, 80.0);
        for t in ticks::multiples(step, [self.from, self.to]) {
            canvas.rule([self.x(t), top], [self.x(t), bottom], "grid");
        }
        canvas.frame([LEFT, top], [RIGHT - LEFT, bottom - top]);
    }

    /// Draws the starts of moves, with labels where there is space. Consecutive moves with the same label share it.
    pub(super) fn starts(&self, picture: &Picture, canvas: &mut Canvas, [top, bottom]: [f64; 2]) {
        let mut free = f64::NEG_INFINITY;
        let mut last = String::new();
        let only = picture.only_program().is_some();
        for mark in &picture.moves {
            let Some(x) = mark.started.map(|t| self.x(t)).filter(|x| (LEFT - 1.0..=RIGHT + 1.0).contains(x)) else {
                continue;
            };
            if x >= free {
                canvas.rule([x, top], [x, bottom], "start");
                let label = if only { mark.line.to_string() } else { mark.label() };
                if label != last {
                    canvas.upright([x + 4.0, top - 5.0], "label", &label);
                    last = label;
                }
                free = x + APART;
            }
        }
    }
}
