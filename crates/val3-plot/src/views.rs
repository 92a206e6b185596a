//! The path of the tool centre point from three sides, at one scale.

use std::collections::BTreeMap;

use crate::canvas::Canvas;
use crate::labels::Labels;
use crate::thinning::thinned;
use crate::ticks;
use crate::{Picture, REFERENCE, colour};

/// Size of a panel in pixels, and the space around its drawing.
const SIZE: [f64; 2] = [490.0, 470.0];
const MARGIN: f64 = 36.0;

/// Distance of arrows along the path, in pixels.
const ARROWS: f64 = 110.0;

/// The smallest width that a panel shows, in mm.
const SMALLEST: f64 = 20.0;

/// A view: its name, and which coordinates go to the right and upwards.
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

/// A line with more targets than this is a loop.
const REPEATED: usize = 3;

const NAMES: [&str; 3] = ["x", "y", "z"];

/// Draws the views from `top` on, and returns where they end.
pub(crate) fn draw(picture: &Picture, canvas: &mut Canvas, top: f64) -> f64 {
    let extents = extents(picture);
    let widest = extents.iter().map(|[low, high]| high - low).fold(SMALLEST, f64::max);
    let [width, height] = SIZE;
    let scale = (width.min(height) - 2.0 * MARGIN) / widest;
    for (index, view) in VIEWS.iter().enumerate() {
        let left = 40.0 + index as f64 * (width + 25.0);
        let panel = Panel { view, corner: [left, top], extents: &extents, scale };
        panel.draw(picture, canvas);
    }
    top + height
}

/// Lowest and highest coordinates of everything that is drawn.
fn extents(picture: &Picture) -> [[f64; 2]; 3] {
    let marks = picture.moves.iter().flat_map(|mark| [Some(mark.target), mark.leave, mark.reach]).flatten();
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

/// A view in its place.
struct Panel<'a> {
    view: &'a View,
    corner: [f64; 2],
    extents: &'a [[f64; 2]; 3],
    /// Pixels a millimetre.
    scale: f64,
}

impl Panel<'_> {
    fn draw(&self, picture: &Picture, canvas: &mut Canvas) {
        self.grid(canvas);
        self.reference(picture, canvas);
        self.path(picture, canvas);
        self.marks(picture, canvas);
    }

    /// The pixels of a point.
    fn at(&self, point: &[f64; 3]) -> [f64; 2] {
        let [left, top] = self.corner;
        let [width, height] = SIZE;
        let from_middle = |index: usize| {
            let [low, high] = self.extents.get(index).copied().unwrap_or_default();
            (point.get(index).copied().unwrap_or_default() - (low + high) / 2.0) * self.scale
        };
        [left + width / 2.0 + from_middle(self.view.right), top + height / 2.0 - from_middle(self.view.up)]
    }

    fn grid(&self, canvas: &mut Canvas) {
        let ([left, top], [width, height]) = (self.corner, SIZE);
        let step = ticks::step(self.scale, 60.0);
        let middle = |index: usize| {
            let [low, high] = self.extents.get(index).copied().unwrap_or_default();
            (low + high) / 2.0
        };
        let range = |index, size: f64| {
            let half = size / 2.0 / self.scale;
            [middle(index) - half, middle(index) + half]
        };
        let label = |value| ticks::shown(value, step);
        for value in ticks::multiples(step, range(self.view.right, width)) {
            let x = left + width / 2.0 + (value - middle(self.view.right)) * self.scale;
            canvas.rule([x, top], [x, top + height], "grid");
            canvas.text([x, top + height - 5.0], "tick centre", &label(value));
        }
        for value in ticks::multiples(step, range(self.view.up, height)) {
            let y = top + height / 2.0 - (value - middle(self.view.up)) * self.scale;
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

    /// The path, in pieces of one phase each.
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

    fn arrows(&self, picture: &Picture, canvas: &mut Canvas) {
        let mut way = ARROWS / 2.0;
        for pair in picture.samples.windows(2) {
            let [from, to] = pair else { continue };
            let ([x1, y1], [x2, y2]) = (self.at(&from.position), self.at(&to.position));
            let length = libm::hypot(x2 - x1, y2 - y1);
            way += length;
            if way > ARROWS && length > 1e-6 {
                way = 0.0;
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

    fn marks(&self, picture: &Picture, canvas: &mut Canvas) {
        let ([left, top], [width, height]) = (self.corner, SIZE);
        let mut labels = Labels::within([left + 2.0, top + 24.0, left + width - 2.0, top + height - 16.0]);
        if let Some(first) = picture.samples.first() {
            start(canvas, self.at(&first.position));
        }
        for mark in &picture.moves {
            for (point, draw) in [(mark.leave, leave as fn(&mut Canvas, [f64; 2])), (mark.reach, reach)] {
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
        if let Some(gap) = &picture.deviation {
            let (at, nearest) = (self.at(&gap.at), self.at(&gap.nearest));
            canvas.rule(at, nearest, "deviation");
            deviation(canvas, at);
            self.label(&mut labels, canvas, (at, "deviation label"), &gap.label);
        }
        for (point, text) in self.named(picture) {
            target(canvas, point);
            if !text.is_empty() {
                self.label(&mut labels, canvas, (point, "label"), &text);
            }
        }
    }

    /// A label near a point, if there is room.
    fn label(&self, labels: &mut Labels, canvas: &mut Canvas, (point, class): ([f64; 2], &str), text: &str) {
        let Some(place) = labels.place(point, text) else { return };
        if let Some(anchor) = place.anchor {
            canvas.rule(point, anchor, "leader");
        }
        canvas.text(place.at, class, text);
    }

    /// The targets with the labels of their moves. Moves to the same place share one, and a line that moves to many
    /// places has its label at the first of them.
    fn named(&self, picture: &Picture) -> Vec<([f64; 2], String)> {
        let mut named: Vec<([f64; 2], Vec<&str>)> = Vec::new();
        for mark in &picture.moves {
            let [x, y] = self.at(&mark.target);
            match named.iter_mut().find(|([other_x, other_y], _)| libm::hypot(other_x - x, other_y - y) < 3.0) {
                Some((_, labels)) if labels.contains(&mark.label.as_str()) => {}
                Some((_, labels)) => labels.push(&mark.label),
                None => named.push(([x, y], vec![&mark.label])),
            }
        }
        let mut loops = loops(named.iter().flat_map(|(_, labels)| labels).copied());
        for (label, count) in &mut loops {
            *count = picture.moves.iter().filter(|mark| mark.label == *label).count();
        }
        let mut shown = |label: &str| match loops.get_mut(label).map(std::mem::take) {
            None => Some(label.to_owned()),
            Some(0) => None,
            Some(count) => Some(format!("{label} ({count} moves)")),
        };
        let mut text = |labels: Vec<&str>| together(&labels.into_iter().filter_map(&mut shown).collect::<Vec<_>>());
        named.into_iter().map(|(point, labels)| (point, text(labels))).collect()
    }
}

/// The labels that are at more than [`REPEATED`] targets, with their numbers of targets.
fn loops<'a>(labels: impl Iterator<Item = &'a str>) -> BTreeMap<&'a str, usize> {
    let mut counts = BTreeMap::new();
    labels.for_each(|label| *counts.entry(label).or_default() += 1);
    counts.retain(|_, count| *count > REPEATED);
    counts
}

/// Several labels as one: the program is written once.
fn together(labels: &[String]) -> String {
    const MOST: usize = 4;
    let mut text = String::new();
    let mut program = "";
    for label in labels.iter().map(String::as_str).take(MOST) {
        let (own, line) = label.rsplit_once(':').unwrap_or((label, ""));
        let written = if own == program && !line.is_empty() { line } else { label };
        text += if text.is_empty() { "" } else { ", " };
        text += written;
        program = own;
    }
    if labels.len() > MOST { text + " …" } else { text }
}

/// The mark of the start.
pub(crate) fn start(canvas: &mut Canvas, [x, y]: [f64; 2]) {
    let corners = [[x - 4.5, y - 4.5], [x + 4.5, y - 4.5], [x + 4.5, y + 4.5], [x - 4.5, y + 4.5], [x - 4.5, y - 4.5]];
    canvas.path(&corners, "stroke:#222;stroke-width:1.5;fill:#fff");
}

/// The mark of a target.
pub(crate) fn target(canvas: &mut Canvas, [x, y]: [f64; 2]) {
    for sign in [1.0, -1.0] {
        canvas.line([x - 5.0, y - 5.0 * sign], [x + 5.0, y + 5.0 * sign], "stroke:#222;stroke-width:1.5");
    }
}

/// The mark of a leave point.
pub(crate) fn leave(canvas: &mut Canvas, at: [f64; 2]) {
    canvas.circle(at, 3.5, "fill:#fff;stroke:#b37400;stroke-width:1.5");
}

/// The mark of a reach point.
pub(crate) fn reach(canvas: &mut Canvas, at: [f64; 2]) {
    canvas.circle(at, 3.5, "fill:#b37400;stroke:#b37400;stroke-width:1.5");
}

/// The mark of the largest deviation.
pub(crate) fn deviation(canvas: &mut Canvas, at: [f64; 2]) {
    canvas.circle(at, 8.0, "fill:none;stroke:#c00000;stroke-width:2.5");
}
