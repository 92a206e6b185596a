//! Charts of joints, speeds and distances over time.

mod chart;
mod distances;
mod limited_by;
mod positions;
mod rates;
mod time;

use crate::Picture;
use crate::canvas::Canvas;
use limited_by::LimitedBy;
use rates::Rate;
use time::Time;

/// Height of the move labels with and without the program name, in pixels.
const LABELS: f64 = 78.0;
const LINES: f64 = 30.0;

/// Space above an axis strip, and above a rate chart for its name, in pixels.
const GAP: f64 = 8.0;
const NAME: f64 = 30.0;

/// Height of a text line below the charts, and base line of the legend below the strip of limits, in pixels.
const LINE: f64 = 24.0;
const LEGEND: f64 = 38.0;

/// Draws the charts from `top` on. Returns their lower end.
pub(crate) fn draw(picture: &Picture, canvas: &mut Canvas, top: f64) -> f64 {
    let time = Time::of(picture);
    let top = top + if picture.only_program().is_some() { LINES } else { LABELS };
    let rates = Rate::all(picture);
    let strips = picture.axes.len() as f64;
    let has_distances = distances::has_distances(picture);
    let charts = rates.len() + usize::from(has_distances);
    let bottom = top + strips * (positions::HEIGHT + GAP) + charts as f64 * (rates::HEIGHT + NAME);
    time.starts(picture, canvas, [top, bottom]);
    if let Some(deviation) = &picture.deviation {
        canvas.rule([time.x(deviation.t), top], [time.x(deviation.t), bottom], "deviation");
    }
    let mut y = top;
    for index in 0..picture.axes.len() {
        positions::draw(picture, canvas, &time, index, y);
        y += positions::HEIGHT + GAP;
    }
    for rate in rates {
        rate.draw(picture, canvas, &time, y + NAME - GAP);
        y += rates::HEIGHT + NAME;
    }
    if has_distances {
        distances::draw(picture, canvas, &time, y + NAME - GAP);
        y += rates::HEIGHT + NAME;
    }
    if let Some(strip) = LimitedBy::of(picture, &time) {
        strip.draw(canvas, y);
        y += limited_by::HEIGHT;
        strip.legend(canvas, y + LEGEND);
        time.axis(canvas, y);
        y += LINE;
    } else {
        time.axis(canvas, y);
    }
    y += LINE;
    if let Some(note) = &picture.times_note {
        y += LINE;
        canvas.text([time::LEFT, y], "small", note);
    }
    y
}
