//! A chart of values over time.

use super::time::{LEFT, RIGHT, Time};
use crate::canvas::Canvas;
use crate::colours::REFERENCE;
use crate::in_force::{InForce, LimitStep};
use crate::thinning::thinned;
use crate::{Sample, ticks};

/// Space between the frame and the highest and lowest values, in pixels.
const INSIDE: f64 = 5.0;

/// Minimum width of a limit's label, in pixels.
const LABEL: f64 = 74.0;

/// Style of a curve where it is at a limit.
const AT_LIMIT: &str = "stroke:#d00000;stroke-opacity:.4;stroke-width:6;stroke-linejoin:round;stroke-linecap:round";

/// A frame with a time axis and a value axis.
pub(super) struct Chart<'a> {
    time: &'a Time,
    bottom: f64,
    range: [f64; 2],
    /// Pixels for each unit.
    scale: f64,
}

impl<'a> Chart<'a> {
    /// Draws the frame and the grid between `top` and `bottom`. Grid values are at least `apart` pixels apart.
    pub(super) fn new(
        canvas: &mut Canvas,
        time: &'a Time,
        [top, bottom]: [f64; 2],
        range: [f64; 2],
        apart: f64,
    ) -> Self {
        let [low, high] = range;
        let chart = Self { time, bottom, range, scale: (bottom - top - 2.0 * INSIDE) / (high - low).max(1e-9) };
        let step = ticks::step(chart.scale, apart);
        for value in ticks::multiples(step, range) {
            let y = chart.y(value);
            canvas.rule([LEFT, y], [RIGHT, y], "grid");
            canvas.text([LEFT - 6.0, y + 4.0], "tick right", &ticks::shown(value, step));
        }
        time.grid(canvas, [top, bottom]);
        chart
    }

    /// Returns the y coordinate of a value in pixels.
    pub(super) fn y(&self, value: f64) -> f64 {
        self.bottom - INSIDE - (value - self.range[0]) * self.scale
    }

    /// Whether a value is within the drawn range.
    pub(super) fn shows(&self, value: f64) -> bool {
        (self.range[0]..=self.range[1]).contains(&value)
    }

    /// Draws a curve; `values` are times in seconds with values.
    pub(super) fn curve(&self, canvas: &mut Canvas, colour: &str, values: impl Iterator<Item = (f64, f64)>) {
        self.path(canvas, values, &format!("stroke:{colour};stroke-width:1.6"));
    }

    /// Draws a curve of the recorded motion.
    pub(super) fn reference(&self, canvas: &mut Canvas, samples: &[Sample], value: impl Fn(&Sample) -> f64) {
        self.path(canvas, samples.iter().map(|sample| (sample.t, value(sample))), REFERENCE);
    }

    /// Draws a band along a curve where its values are at a limit, from the preceding value on.
    pub(super) fn at_limit(&self, canvas: &mut Canvas, values: &[(f64, f64)], is_at_limit: impl Fn(f64, f64) -> bool) {
        let mut piece: Vec<(f64, f64)> = Vec::new();
        for pair in values.windows(2) {
            let [before, (t, value)] = pair else { continue };
            if is_at_limit(*t, *value) {
                if piece.is_empty() {
                    piece.push(*before);
                }
                piece.push((*t, *value));
            } else {
                self.path(canvas, piece.drain(..), AT_LIMIT);
            }
        }
        self.path(canvas, piece.into_iter(), AT_LIMIT);
    }

    fn path(&self, canvas: &mut Canvas, values: impl Iterator<Item = (f64, f64)>, style: &str) {
        let points: Vec<_> = values.map(|(t, value)| [self.time.x(t), self.y(value)]).collect();
        canvas.path(&thinned(&points), style);
    }

    /// Draws the limits of moves that are within the range. Every new limit is labelled with `name` and its value.
    pub(super) fn limits(&self, canvas: &mut Canvas, limits: &InForce, name: &str, sign: f64) {
        let mut labelled = None;
        let mut free = f64::NEG_INFINITY;
        for step in limits.steps().iter().filter(|step| self.shows(sign * step.value)) {
            let LimitStep { from, to, value } = *step;
            let ([from, to], y) = ([from, to].map(|t| self.time.x_within(t)), self.y(sign * value));
            canvas.rule([from, y], [to, y], "limit");
            if labelled != Some(value) && from >= free && RIGHT - from > LABEL {
                let below = if sign < 0.0 { 12.0 } else { -4.0 };
                canvas.text([from + 3.0, y + below], "limit-label", &format!("{name} {}", shown(value)));
                (labelled, free) = (Some(value), from + LABEL);
            }
        }
        for [before, after] in limits.steps().windows(2).filter_map(|pair| <&[LimitStep; 2]>::try_from(pair).ok()) {
            if after.from <= before.to && self.shows(sign * before.value) && self.shows(sign * after.value) {
                let x = self.time.x_within(after.from);
                canvas.rule([x, self.y(sign * before.value)], [x, self.y(sign * after.value)], "limit");
            }
        }
    }
}

/// Formats a limit without unnecessary decimals.
pub(super) fn shown(value: f64) -> String {
    let text = format!("{value:.2}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// Draws the legend of limits at the right end of the names.
pub(super) fn legend(canvas: &mut Canvas, y: f64) {
    canvas.rule([RIGHT - 190.0, y - 4.0], [RIGHT - 164.0, y - 4.0], "limit");
    canvas.text([RIGHT - 158.0, y], "small", "limit");
    canvas.line([RIGHT - 106.0, y - 4.0], [RIGHT - 84.0, y - 4.0], AT_LIMIT);
    canvas.text([RIGHT - 74.0, y], "small", "at the limit");
}
