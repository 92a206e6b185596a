//! Title and legend.

use crate::canvas::Canvas;
use crate::colours::{PHASES, REFERENCE};
use crate::{MotionPhase, Picture, Sample, marks};

/// Function that draws a mark at the coordinates.
type DrawMark = fn(&mut Canvas, [f64; 2]);

/// Left end of the legend.
const LEGEND: f64 = 420.0;

/// Draws the title and the legend at the top of the picture.
pub(crate) fn draw(picture: &Picture, canvas: &mut Canvas) {
    canvas.text([40.0, 34.0], "title", &picture.title);
    canvas.text([40.0, 56.0], "small", &summary(picture));
    paths(picture, canvas);
    let x = points(picture, canvas);
    if let Some(deviation) = &picture.deviation {
        marks::deviation(canvas, [x + 13.0, 52.0]);
        canvas.text([x + 32.0, 56.0], "small", &format!("largest deviation: {}", deviation.label));
    }
}

/// Formats the arm, the number of moves, and the duration.
fn summary(picture: &Picture) -> String {
    let moves = match (picture.moves.len(), picture.only_program()) {
        (1, Some(program)) => format!("1 move (line of {program})"),
        (count, Some(program)) => format!("{count} moves (lines of {program})"),
        (count, None) => format!("{count} moves"),
    };
    let times = format!("{:.3} s", length(&picture.samples));
    let times = match picture.reference.is_empty() {
        true => times,
        false => format!("{times}, recorded {:.3} s", length(&picture.reference)),
    };
    format!("{}, {moves}, {times}", picture.arm)
}

/// Draws the colours of the paths that occur.
fn paths(picture: &Picture, canvas: &mut Canvas) {
    let moving = PHASES.iter().filter(|(phase, ..)| *phase != MotionPhase::Waiting);
    let used = moving.filter(|(phase, ..)| picture.samples.iter().any(|sample| sample.phase == *phase));
    let mut x = LEGEND;
    for (_, colour, name) in used {
        canvas.line([x, 30.0], [x + 26.0, 30.0], &format!("stroke:{colour};stroke-width:3"));
        x = named(canvas, [x, 34.0], name);
    }
    if !picture.reference.is_empty() {
        canvas.line([x, 30.0], [x + 26.0, 30.0], REFERENCE);
        named(canvas, [x + 6.0, 34.0], "recorded");
    }
}

/// Draws the marks of points. Returns the x coordinate after the last entry.
fn points(picture: &Picture, canvas: &mut Canvas) -> f64 {
    let mut points: Vec<(&str, DrawMark)> = vec![("start", marks::start), ("target", marks::target)];
    if picture.moves.iter().any(|mark| mark.intermediate.is_some()) {
        points.push(("intermediate point", marks::intermediate));
    }
    points.extend([("leave", marks::leave as DrawMark), ("reach", marks::reach)]);
    let mut x = LEGEND;
    for (name, draw) in points {
        draw(canvas, [x + 13.0, 52.0]);
        x = named(canvas, [x, 56.0], name);
    }
    x
}

/// Draws an entry's name at the coordinates. Returns the x coordinate for the next entry.
fn named(canvas: &mut Canvas, [x, y]: [f64; 2], name: &str) -> f64 {
    canvas.text([x + 32.0, y], "small", name);
    x + 50.0 + 7.5 * name.len() as f64
}

/// Returns the seconds from the first sample to the last sample.
fn length(samples: &[Sample]) -> f64 {
    samples.first().zip(samples.last()).map_or(0.0, |(first, last)| last.t - first.t)
}
