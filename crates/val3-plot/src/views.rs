//! Three views of the tool path, with the same scale.

mod arrows;
mod names;

use std::collections::BTreeSet;

use crate::canvas::Canvas;
use crate::colours::{REFERENCE, colour};
use crate::labels::{LabelDistance, LabelPosition, Labels};
use crate::thinning::thinned;
use crate::ticks;
use crate::{Picture, marks};
use arrows::{Arrows, SPACING};
use names::{Named, ProgramLine, SAME};

/// Size of a panel, and space around its drawing, in pixels.
const SIZE: [f64; 2] = [490.0, 470.0];
const MARGIN: f64 = 36.0;

/// Minimum width of a panel's content in mm.
const SMALLEST: f64 = 20.0;

/// A view: its name, and the coordinates that point to the right and upwards.
struct View {
    name: &'static str,
    right: usize,
    up: usize,
}

const VIEWS: [View; 3] = [
    View { name: "top: x, y", right: 0, up: 1 },
    View { name: "front: x, z", right: 0, up: 2 },
    View { name: "side: y, z", right: 1, up: 2 },
];

const NAMES: [&str; 3] = ["x", "y", "z"];

/// Draws the views from `top` on. Returns their lower end.
pub(crate) fn draw(picture: &Picture, canvas: &mut Canvas, top: f64) -> f64 {
    let extents = extents(picture);
    let widest = extents.iter().map(|[low, high]| high - low).fold(SMALLEST, f64::max);
    let [width, height] = SIZE;
    let scale = (width.min(height) - 2.0 * MARGIN) / widest;
    let mut written = Written::default();
    for (index, view) in VIEWS.iter().enumerate() {
        let left = 40.0 + index as f64 * (width + 25.0);
        let panel = Panel { view, corner: [left, top], extents: &extents, scale };
        panel.draw(picture, canvas, &mut written);
    }
    top + height
}

/// Returns the lowest and the highest coordinates of all content.
fn extents(picture: &Picture) -> [[f64; 2]; 3] {
    let marks = picture.moves.iter();
    let marks = marks.flat_map(|mark| [Some(mark.target), mark.intermediate, mark.leave, mark.reach]).flatten();
    let mut extents = [[f64::INFINITY, f64::NEG_INFINITY]; 3];
    let samples = picture.samples.iter().chain(&picture.reference).map(|sample| sample.position);
    for point in samples.chain(marks) {
        for ([low, high], coordinate) in extents.iter_mut().zip(point).filter(|(_, coordinate)| coordinate.is_finite())
        {
            (*low, *high) = (low.min(coordinate), high.max(coordinate));
        }
    }
    extents.map(|[low, high]| if low <= high { [low, high] } else { [0.0, 0.0] })
}

/// Labels that were drawn in previous views.
#[derive(Default)]
struct Written<'a> {
    /// Program lines of targets.
    targets: BTreeSet<ProgramLine<'a>>,
    /// Notes on blends with their positions in world.
    notes: Vec<([f64; 3], &'a str)>,
}

/// A view at its place in the picture.
struct Panel<'a> {
    view: &'a View,
    corner: [f64; 2],
    extents: &'a [[f64; 2]; 3],
    /// Pixels for each millimetre.
    scale: f64,
}

impl Panel<'_> {
    fn draw<'p>(&self, picture: &'p Picture, canvas: &mut Canvas, written: &mut Written<'p>) {
        self.grid(canvas);
        self.reference(picture, canvas);
        self.path(picture, canvas);
        self.marks(picture, canvas, written);
    }

    /// Returns the pixel coordinates of a point.
    fn at(&self, point: &[f64; 3]) -> [f64; 2] {
        let [left, top] = self.corner;
        let [width, height] = SIZE;
        let [right, up] = [self.view.right, self.view.up]
            .map(|index| self.distance_from_middle(index, point.get(index).copied().unwrap_or_default()));
        [left + width / 2.0 + right, top + height / 2.0 - up]
    }

    /// Returns the distance of a coordinate from the middle of the extent, in pixels.
    fn distance_from_middle(&self, index: usize, coordinate: f64) -> f64 {
        (coordinate - self.middle(index)) * self.scale
    }

    /// Returns the middle of the extent along an axis of world, in mm.
    fn middle(&self, index: usize) -> f64 {
        let [low, high] = self.extents.get(index).copied().unwrap_or_default();
        (low + high) / 2.0
    }

    /// Returns the visible coordinates along an axis of world that has `size` pixels, in mm.
    fn visible(&self, index: usize, size: f64) -> [f64; 2] {
        let (middle, half) = (self.middle(index), size / 2.0 / self.scale);
        [middle - half, middle + half]
    }

    fn grid(&self, canvas: &mut Canvas) {
        let ([left, top], [width, height]) = (self.corner, SIZE);
        let step = ticks::step(self.scale, 60.0);
        let label = |value| ticks::shown(value, step);
        for value in ticks::multiples(step, self.visible(self.view.right, width)) {
            let x = left + width / 2.0 + self.distance_from_middle(self.view.right, value);
            canvas.rule([x, top], [x, top + height], "grid");
            canvas.text([x, top + height - 5.0], "tick centre", &label(value));
        }
        for value in ticks::multiples(step, self.visible(self.view.up, height)) {
            let y = top + height / 2.0 - self.distance_from_middle(self.view.up, value);
            canvas.rule([left, y], [left + width, y], "grid");
            if (top + 34.0..top + height - 20.0).contains(&y) {
                canvas.text([left + 4.0, y - 3.0], "tick", &label(value));
            }
        }
        canvas.frame(self.corner, SIZE);
        canvas.text([left + 8.0, top + 18.0], "label", &format!("{} (mm)", self.view.name));
        let names = [self.view.right, self.view.up].map(|index| NAMES.get(index).copied().unwrap_or_default());
        let [right, up] = names;
        canvas.text([left + width - 8.0, top + height - 18.0], "label right", &format!("{right} \u{2192}"));
        canvas.text([left + width - 8.0, top + 18.0], "label right", &format!("{up} \u{2191}"));
    }

    fn reference(&self, picture: &Picture, canvas: &mut Canvas) {
        let points: Vec<_> = picture.reference.iter().map(|sample| self.at(&sample.position)).collect();
        canvas.path(&thinned(&points), REFERENCE);
    }

    /// Draws the path in pieces, one for each phase.
    fn path(&self, picture: &Picture, canvas: &mut Canvas) {
        let samples = &picture.samples;
        let mut first = 0;
        while let Some(phase) = samples.get(first + 1).map(|sample| sample.phase) {
            let piece = samples.iter().skip(first + 1).take_while(|sample| sample.phase == phase).count();
            let points: Vec<_> =
                samples.iter().skip(first).take(piece + 1).map(|sample| self.at(&sample.position)).collect();
            let style = format!("stroke:{};stroke-width:2;stroke-linejoin:round", colour(phase));
            canvas.path(&thinned(&points), &style);
            first += piece;
        }
        self.arrows(picture, canvas);
    }

    /// Draws arrows along the path. Further cycles on the same path have no arrows of their own.
    fn arrows(&self, picture: &Picture, canvas: &mut Canvas) {
        let mut arrows = Arrows::default();
        let mut way = SPACING / 2.0;
        for pair in picture.samples.windows(2) {
            let [from, to] = pair else { continue };
            let ([x1, y1], [x2, y2]) = (self.at(&from.position), self.at(&to.position));
            let length = libm::hypot(x2 - x1, y2 - y1);
            way += length;
            if way > SPACING && length > 1e-6 {
                way = 0.0;
                if !arrows.add([x2, y2], [(x2 - x1) / length, (y2 - y1) / length]) {
                    continue;
                }
                let (along_x, along_y) = ((x2 - x1) / length * 5.0, (y2 - y1) / length * 5.0);
                let tip = [x2 + along_x, y2 + along_y];
                let wings = [
                    [x2 - along_x - along_y, y2 - along_y + along_x],
                    [x2 - along_x + along_y, y2 - along_y - along_x],
                ];
                let [left, right] = wings;
                canvas.path(&[left, tip, right, left], &format!("fill:{};stroke:none", colour(to.phase)));
            }
        }
    }

    /// Draws the marks with their labels. A label far from its target is drawn only if no previous view contains it.
    fn marks<'p>(&self, picture: &'p Picture, canvas: &mut Canvas, written: &mut Written<'p>) {
        let mut labels = self.points(picture, canvas);
        if let Some(gap) = &picture.deviation {
            let (at, nearest) = (self.at(&gap.at), self.at(&gap.nearest));
            canvas.rule(at, nearest, "deviation");
            marks::deviation(canvas, at);
            if let Some(place) = labels.place(at, &gap.label, LabelDistance::Far) {
                leader(canvas, &place, at);
                canvas.text(place.at, "deviation label", &gap.label);
            }
        }
        for Named { point, origins, text } in Named::all(picture, |target| self.at(target)) {
            marks::target(canvas, point);
            if text.is_empty() {
                continue;
            }
            let reach = if origins.iter().all(|origin| written.targets.contains(origin)) {
                LabelDistance::Near
            } else {
                LabelDistance::Far
            };
            if let Some(place) = labels.place(point, &text, reach) {
                leader(canvas, &place, point);
                canvas.text(place.at, "label", &text);
                written.targets.extend(origins);
            }
        }
        self.notes(picture, canvas, &mut labels, written);
    }

    /// Draws each note on a blend in the first view that has space for it. Equal notes at the same place share a label.
    fn notes<'p>(&self, picture: &'p Picture, canvas: &mut Canvas, labels: &mut Labels, written: &mut Written<'p>) {
        for mark in &picture.moves {
            let (Some(leave), Some(note)) = (mark.leave, &mark.note) else { continue };
            let is_same = |(at, text): &([f64; 3], &str)| text == note && self.is_same(at, &leave);
            if written.notes.iter().any(is_same) {
                continue;
            }
            let point = self.at(&leave);
            let Some(place) = labels.place(point, note, LabelDistance::Near) else { continue };
            leader(canvas, &place, point);
            match &mark.explanation {
                Some(explanation) => canvas.explained(place.at, "note", note, explanation),
                None => canvas.text(place.at, "note", note),
            }
            written.notes.push((leave, note));
        }
    }

    /// Whether two points coincide in the picture.
    fn is_same(&self, one: &[f64; 3], other: &[f64; 3]) -> bool {
        one.iter().zip(other).all(|(one, other)| (one - other).abs() * self.scale < SAME)
    }

    /// Draws the marks of points. Returns the free space for labels next to the marks and the path.
    fn points(&self, picture: &Picture, canvas: &mut Canvas) -> Labels {
        let ([left, top], [width, height]) = (self.corner, SIZE);
        let mut labels = Labels::within([left + 2.0, top + 24.0, left + width - 2.0, top + height - 16.0]);
        if let Some(first) = picture.samples.first() {
            marks::start(canvas, self.at(&first.position));
        }
        for mark in &picture.moves {
            if let Some(point) = mark.intermediate {
                marks::intermediate(canvas, self.at(&point));
                labels.avoid(self.at(&point));
            }
            for (point, draw) in [(mark.leave, marks::leave as fn(&mut Canvas, [f64; 2])), (mark.reach, marks::reach)] {
                if let Some(point) = point {
                    draw(canvas, self.at(&point));
                }
            }
            labels.avoid(self.at(&mark.target));
        }
        for pair in picture.samples.windows(2).chain(picture.reference.windows(2)) {
            let [from, to] = pair else { continue };
            labels.avoid_line(self.at(&from.position), self.at(&to.position));
        }
        labels
    }
}

/// Draws the leader line from a point to a label that is not next to it.
fn leader(canvas: &mut Canvas, place: &LabelPosition, point: [f64; 2]) {
    if let Some(anchor) = place.anchor {
        canvas.rule(point, anchor, "leader");
    }
}
