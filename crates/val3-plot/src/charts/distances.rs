//! Chart of the smallest distance between things over time.

use super::chart::Chart;
use super::rates::HEIGHT;
use super::time::{LEFT, RIGHT, Time};
use crate::canvas::Canvas;
use crate::{DistanceSample, Picture};

/// Colour of the curve.
const COLOUR: &str = "#0b6e4f";

/// Ratio of the chart's range to its largest distance, so that the label of the smallest one has space.
const HEADROOM: f64 = 1.12;

/// Space in pixels that the label of the smallest distance needs at the right end.
const LABEL: f64 = 320.0;

/// Whether the picture has distances.
pub(super) fn has_distances(picture: &Picture) -> bool {
    picture.distances.iter().any(|sample| sample.distance.is_some())
}

/// Draws the chart from `top` on.
pub(super) fn draw(picture: &Picture, canvas: &mut Canvas, time: &Time, top: f64) {
    let shown: Vec<&DistanceSample> = picture.distances.iter().filter(|sample| time.contains(sample.t)).collect();
    let distances = || shown.iter().filter_map(|sample| sample.distance);
    let clearance = shown.iter().map(|sample| sample.clearance).fold(0.0, f64::max);
    let lowest = distances().fold(0.0, f64::min);
    let highest = distances().fold(clearance.max(1.0), f64::max) * HEADROOM;
    let chart = Chart::new(canvas, time, [top, top + HEIGHT], [lowest, highest], 26.0);
    canvas.text([LEFT, top - 6.0], "label", "smallest distance (mm)");
    for clearance in clearances(&shown) {
        canvas.rule([LEFT, chart.y(clearance)], [RIGHT, chart.y(clearance)], "limit");
        let name = format!("clearance {}", super::chart::shown(clearance));
        canvas.text([RIGHT - 4.0, chart.y(clearance) - 4.0], "limit-label right", &name);
    }
    for piece in shown.split(|sample| sample.distance.is_none()) {
        chart.curve(canvas, COLOUR, piece.iter().filter_map(|sample| Some((sample.t, sample.distance?))));
    }
    let nearest = shown.iter().filter_map(|sample| Some((sample, sample.distance?)));
    if let Some((sample, distance)) = nearest.min_by(|(_, one), (_, other)| one.total_cmp(other)) {
        let at = [time.x(sample.t), chart.y(distance)];
        canvas.circle(at, 4.0, "fill:none;stroke:#0b6e4f;stroke-width:2");
        let (x, class) = if at[0] > RIGHT - LABEL { (at[0] - 8.0, "label right") } else { (at[0] + 8.0, "label") };
        canvas.text([x, at[1] - 6.0], class, &format!("{}: {distance:.1} mm", sample.pair));
    }
}

/// Returns the clearances above 0 that occur, each once.
fn clearances(samples: &[&DistanceSample]) -> Vec<f64> {
    let mut found: Vec<f64> = samples.iter().map(|sample| sample.clearance).filter(|value| *value > 0.0).collect();
    found.sort_by(f64::total_cmp);
    found.dedup();
    found
}
