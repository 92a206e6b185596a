//! Marks of points.

use crate::canvas::Canvas;

/// Draws the mark of the start.
pub(crate) fn start(canvas: &mut Canvas, [x, y]: [f64; 2]) {
    let corners = [[x - 4.5, y - 4.5], [x + 4.5, y - 4.5], [x + 4.5, y + 4.5], [x - 4.5, y + 4.5], [x - 4.5, y - 4.5]];
    canvas.path(&corners, "stroke:#222;stroke-width:1.5;fill:#fff");
}

/// Draws the mark of a target.
pub(crate) fn target(canvas: &mut Canvas, [x, y]: [f64; 2]) {
    for sign in [1.0, -1.0] {
        canvas.line([x - 5.0, y - 5.0 * sign], [x + 5.0, y + 5.0 * sign], "stroke:#222;stroke-width:1.5");
    }
}

/// Draws the mark of a circle's intermediate point.
pub(crate) fn intermediate(canvas: &mut Canvas, [x, y]: [f64; 2]) {
    let corners = [[x, y - 5.0], [x + 5.0, y], [x, y + 5.0], [x - 5.0, y], [x, y - 5.0]];
    canvas.path(&corners, "stroke:#222;stroke-width:1.5;fill:#fff");
}

/// Draws the mark of a leave point.
pub(crate) fn leave(canvas: &mut Canvas, at: [f64; 2]) {
    canvas.circle(at, 3.5, "fill:#fff;stroke:#b37400;stroke-width:1.5");
}

/// Draws the mark of a reach point.
pub(crate) fn reach(canvas: &mut Canvas, at: [f64; 2]) {
    canvas.circle(at, 3.5, "fill:#b37400;stroke:#b37400;stroke-width:1.5");
}

/// Draws the mark of the largest deviation.
pub(crate) fn deviation(canvas: &mut Canvas, at: [f64; 2]) {
    canvas.circle(at, 8.0, "fill:none;stroke:#c00000;stroke-width:2.5");
}
