//! Strip over time that shows in colour which limit determines the speed.

use std::collections::BTreeMap;

use super::time::{LEFT, RIGHT, Time};
use crate::canvas::Canvas;
use crate::colours::limit_colour;
use crate::{Picture, SpeedLimit};

/// Height of the strip, in pixels.
pub(super) const HEIGHT: f64 = 14.0;

/// Minimum width in pixels of a piece that shows its axis number.
const NUMBER: f64 = 12.0;

/// Pieces of the strip from left to right: first pixel, pixel after the last, and limit.
pub(super) struct LimitedBy(Vec<(usize, usize, SpeedLimit)>);

impl LimitedBy {
    /// Returns the strip of a picture; `None` if its limits are unknown.
    ///
    /// A pixel shows the limit that is active for most of the pixel's time.
    pub(super) fn of(picture: &Picture, time: &Time) -> Option<Self> {
        let mut columns: Vec<BTreeMap<SpeedLimit, f64>> = vec![BTreeMap::new(); (RIGHT - LEFT) as usize];
        for pair in picture.samples.windows(2) {
            let [sample, next] = pair else { continue };
            let Some(limit) = sample.limit.map(merged) else { continue };
            let [from, to] = [sample.t, next.t].map(|t| time.x_within(t) - LEFT);
            for (number, column) in columns.iter_mut().enumerate().skip(from as usize).take((to - from) as usize + 2) {
                let width = to.min(number as f64 + 1.0) - from.max(number as f64);
                if width > 0.0 {
                    *column.entry(limit).or_default() += width;
                }
            }
        }
        let limits: Vec<_> = columns.iter().map(longest).collect();
        let mut pieces = Vec::new();
        let mut from = 0;
        for equal in limits.chunk_by(|one, other| one == other) {
            let to = from + equal.len();
            pieces.extend(equal.first().copied().flatten().map(|limit| (from, to, limit)));
            from = to;
        }
        (!pieces.is_empty()).then_some(Self(pieces))
    }

    /// Draws the strip from `top` on.
    pub(super) fn draw(&self, canvas: &mut Canvas, top: f64) {
        canvas.text([LEFT - 6.0, top + 11.0], "tick right", "limited by");
        for (from, to, limit) in &self.0 {
            let (x, width) = (LEFT + *from as f64, (to - from) as f64);
            let (name, colour) = limit_colour(*limit);
            let explanation = if limit.axis().is_some() { limit.to_string() } else { name.to_owned() };
            canvas.explained_area([x, top], [width, HEIGHT - 2.0], colour, &explanation);
            if let Some(axis) = limit.axis().filter(|_| width >= NUMBER) {
                canvas.text([x + width / 2.0, top + 10.0], "label centre", &(axis + 1).to_string());
            }
        }
    }

    /// Draws the colours of the limits that occur, on a base line at `y`.
    pub(super) fn legend(&self, canvas: &mut Canvas, y: f64) {
        let mut names: Vec<(&str, &str)> = Vec::new();
        for (.., limit) in &self.0 {
            let entry = limit_colour(*limit);
            if !names.contains(&entry) {
                names.push(entry);
            }
        }
        canvas.text([LEFT - 6.0, y], "small right", "limits");
        let mut x = LEFT;
        for (name, colour) in names {
            canvas.line([x, y - 4.0], [x + 18.0, y - 4.0], &format!("stroke:{colour};stroke-width:10"));
            canvas.text([x + 24.0, y], "small", name);
            x += 44.0 + 7.5 * name.len() as f64;
        }
    }
}

/// Returns the limit with the largest value.
fn longest(column: &BTreeMap<SpeedLimit, f64>) -> Option<SpeedLimit> {
    column.iter().max_by(|(_, one), (_, other)| one.total_cmp(other)).map(|(limit, _)| *limit)
}

/// Merges all reasons for rest.
fn merged(limit: SpeedLimit) -> SpeedLimit {
    match limit {
        SpeedLimit::Fault | SpeedLimit::Held | SpeedLimit::End => SpeedLimit::NextMove,
        other => other,
    }
}
