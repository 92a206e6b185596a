//! Joints and speeds over time.

mod chart;
mod layout;
mod positions;
mod rates;
mod time;

use crate::Picture;
use crate::canvas::Canvas;
use rates::Rate;
use time::Time;

/// Room for the labels of moves with the program, and without it.
const LABELS: f64 = 78.0;
const LINES: f64 = 30.0;

/// Space above a strip of one axis, and above a chart of rates for its name.
const GAP: f64 = 8.0;
const NAME: f64 = 30.0;

/// Draws the charts from `top` on, and returns where they end.
pub(crate) fn draw(picture: &Picture, canvas: &mut Canvas, top: f64) -> f64 {
    let time = Time::of(picture);
    let top = top + if picture.only_program().is_some() { LINES } else { LABELS };
    let rates = Rate::all(picture);
    let strips = picture.axes.len() as f64;
    let bottom = top + strips * (positions::HEIGHT + GAP) + rates.len() as f64 * (rates::HEIGHT + NAME);
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
    time.axis(canvas, y);
    y + 24.0
}
