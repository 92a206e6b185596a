//! Strip with an axis position over time.

use super::chart::{Chart, shown};
use super::time::{LEFT, RIGHT, Time};
use crate::canvas::Canvas;
use crate::colours::AXES;
use crate::{Picture, PictureAxis, Sample};

/// Height of a strip in pixels.
pub(super) const HEIGHT: f64 = 64.0;

/// Minimum range of a strip in degrees or mm. Smaller motion is drawn flatter.
const SMALLEST: f64 = 10.0;

/// Space above and below the used range, as a share of the range.
const PADDING: f64 = 0.08;

/// Distance to a limit in degrees or mm below which an axis is at the limit.
const TOUCH: f64 = 0.01;

/// Draws an axis strip from `top` on: the range that the motion uses, and the axis limits within it.
pub(super) fn draw(picture: &Picture, canvas: &mut Canvas, time: &Time, index: usize, top: f64) {
    let Some(axis) = picture.axes.get(index) else { return };
    let position = |sample: &Sample| sample.joints.get(index).copied().unwrap_or_default();
    let positions: Vec<_> = picture.samples.iter().map(|sample| (sample.t, position(sample))).collect();
    let all = positions.iter().map(|(_, value)| *value).chain(picture.reference.iter().map(position));
    let chart = Chart::new(canvas, time, [top, top + HEIGHT], range(all), 18.0);
    let unit = if axis.is_stroke { "mm" } else { "°" };
    canvas.text([LEFT - 46.0, top + HEIGHT / 2.0 + 4.0], "label right", &format!("j{} ({unit})", index + 1));
    limits(axis, canvas, &chart, [top, top + HEIGHT]);
    chart.reference(canvas, &picture.reference, position);
    chart.at_limit(canvas, &positions, |_, value| value <= axis.min + TOUCH || value >= axis.max - TOUCH);
    chart.curve(canvas, AXES.get(index).copied().unwrap_or("#222"), positions.iter().copied());
    for (t, position) in beyond(axis, &positions) {
        mark_beyond(canvas, [time.x(t), chart.y(position)], position);
    }
}

/// Returns the lowest and the highest position of the strip.
fn range(positions: impl Iterator<Item = f64>) -> [f64; 2] {
    let positions = positions.filter(|position| position.is_finite());
    let used =
        positions.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| [low.min(value), high.max(value)]);
    let [low, high] = if used[0] <= used[1] { used } else { [0.0, 0.0] };
    let half = ((high - low) * (0.5 + PADDING)).max(SMALLEST / 2.0);
    [(low + high) / 2.0 - half, (low + high) / 2.0 + half]
}

/// Draws the axis limits within the range, and shades the area beyond them.
fn limits(axis: &PictureAxis, canvas: &mut Canvas, chart: &Chart<'_>, [top, bottom]: [f64; 2]) {
    for (limit, edge) in [(axis.min, bottom), (axis.max, top)].into_iter().filter(|(limit, _)| chart.shows(*limit)) {
        let y = chart.y(limit);
        canvas.area([LEFT, y.min(edge)], [RIGHT - LEFT, (edge - y).abs()], "beyond");
        canvas.rule([LEFT, y], [RIGHT, y], "limit");
        let below = if edge == top { 11.0 } else { -4.0 };
        canvas.text([RIGHT - 4.0, y + below], "limit-label right", &format!("limit {}", shown(limit)));
    }
}

/// Returns the time and the position that is furthest beyond each limit.
fn beyond(axis: &PictureAxis, positions: &[(f64, f64)]) -> impl Iterator<Item = (f64, f64)> {
    let excess = [|axis: &PictureAxis, value: f64| axis.min - value, |axis: &PictureAxis, value: f64| value - axis.max];
    excess.into_iter().filter_map(|excess| {
        let furthest =
            positions.iter().max_by(|(_, left), (_, right)| excess(axis, *left).total_cmp(&excess(axis, *right)));
        furthest.filter(|(_, value)| excess(axis, *value) > TOUCH).copied()
    })
}

fn mark_beyond(canvas: &mut Canvas, [x, y]: [f64; 2], position: f64) {
    canvas.circle([x, y], 4.0, "fill:none;stroke:#c00000;stroke-width:2");
    let text = format!("{} beyond the limit", shown(position));
    let (x, class) = if x > RIGHT - 180.0 { (x - 8.0, "deviation label right") } else { (x + 8.0, "deviation label") };
    canvas.text([x, y + 4.0], class, &text);
}

#[cfg(test)]
mod tests {
    use super::range;

    #[test]
    fn a_strip_shows_the_used_range() {
        assert_eq!(range([0.0, 100.0].into_iter()).map(f64::round), [-8.0, 108.0]);
        assert_eq!(range([90.0, 90.001].into_iter()).map(f64::round), [85.0, 95.0]);
        assert_eq!(range(std::iter::empty()), [-5.0, 5.0]);
    }
}
