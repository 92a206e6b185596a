//! Joints and speeds over time.

use crate::canvas::{Canvas, WIDTH};
use crate::thinning::thinned;
use crate::{Axis, Picture, REFERENCE, Sample, ticks};

/// Left and right end of the charts.
const LEFT: f64 = 120.0;
const RIGHT: f64 = WIDTH - 40.0;

/// The height of a strip of one axis, and of a chart of speeds.
const STRIP: f64 = 64.0;
const SPEEDS: f64 = 130.0;

/// Colours of axes 1 to 6.
const AXES: [&str; 6] = ["#0072b2", "#e69f00", "#009e73", "#cc79a7", "#56b4e9", "#d55e00"];

/// Room for the labels of moves, and their least distance.
const LABELS: f64 = 78.0;
const APART: f64 = 13.0;

/// Draws the charts from `top` on, and returns where they end.
pub(crate) fn draw(picture: &Picture, canvas: &mut Canvas, top: f64) -> f64 {
    let time = Time::of(picture);
    let strips = picture.axes.len() as f64;
    let bottom = top + LABELS + strips * (STRIP + 8.0) + 2.0 * (SPEEDS + 30.0);
    starts(picture, canvas, &time, [top + LABELS, bottom]);
    if let Some(deviation) = &picture.deviation {
        canvas.rule([time.x(deviation.t), top + LABELS], [time.x(deviation.t), bottom], "deviation");
    }
    let mut y = top + LABELS;
    for (index, axis) in picture.axes.iter().enumerate() {
        strip(picture, canvas, &time, (index, axis), y);
        y += STRIP + 8.0;
    }
    joint_speeds(picture, canvas, &time, y + 22.0);
    y += SPEEDS + 30.0;
    tool_speed(picture, canvas, &time, y + 22.0);
    y += SPEEDS + 30.0;
    time.axis(canvas, y);
    y + 24.0
}

/// The axis of time.
struct Time {
    from: f64,
    to: f64,
    scale: f64,
}

impl Time {
    fn of(picture: &Picture) -> Self {
        let ends = [&picture.samples, &picture.reference].map(|samples| samples.first().zip(samples.last()));
        let ends = ends.into_iter().flatten().map(|(first, last)| [first.t, last.t]);
        let ends = ends.reduce(|[from, to], [other_from, other_to]| [from.min(other_from), to.max(other_to)]);
        let [from, to] = ends.unwrap_or([0.0, 1.0]);
        Self { from, to, scale: (RIGHT - LEFT) / (to - from).max(0.004) }
    }

    fn x(&self, t: f64) -> f64 {
        LEFT + (t - self.from) * self.scale
    }

    fn axis(&self, canvas: &mut Canvas, y: f64) {
        let step = ticks::step(self.scale, 80.0);
        for t in ticks::multiples(step, [self.from, self.to]) {
            canvas.text([self.x(t), y + 14.0], "tick centre", &ticks::shown(t, step));
        }
        canvas.text([LEFT - 12.0, y + 14.0], "small right", "time (s)");
    }

    /// Lines of the grid across a chart.
    fn grid(&self, canvas: &mut Canvas, [top, bottom]: [f64; 2]) {
        let step = ticks::step(self.scale, 80.0);
        for t in ticks::multiples(step, [self.from, self.to]) {
            canvas.rule([self.x(t), top], [self.x(t), bottom], "grid");
        }
        canvas.frame([LEFT, top], [RIGHT - LEFT, bottom - top]);
    }
}

/// Where moves begin, each with its label as far as there is room. Moves of one line that follow each other share one.
fn starts(picture: &Picture, canvas: &mut Canvas, time: &Time, [top, bottom]: [f64; 2]) {
    let mut free = f64::NEG_INFINITY;
    let mut label = "";
    for mark in &picture.moves {
        let Some(x) = mark.started.map(|t| time.x(t)).filter(|x| (LEFT - 1.0..=RIGHT + 1.0).contains(x)) else {
            continue;
        };
        if x >= free {
            canvas.rule([x, top], [x, bottom], "start");
            if mark.label != label {
                canvas.upright([x + 4.0, top - 5.0], "label", &mark.label);
                label = &mark.label;
            }
            free = x + APART;
        }
    }
}

/// The position of an axis between its limits.
fn strip(picture: &Picture, canvas: &mut Canvas, time: &Time, (index, axis): (usize, &Axis), top: f64) {
    let bottom = top + STRIP;
    time.grid(canvas, [top, bottom]);
    let (low, high) = (axis.min, axis.max.max(axis.min + 1e-9));
    let y = |position: f64| bottom - 5.0 - (position - low) / (high - low) * (STRIP - 10.0);
    for limit in [low, high] {
        canvas.rule([LEFT, y(limit)], [RIGHT, y(limit)], "limit");
        canvas.text([LEFT - 6.0, y(limit) + 4.0], "tick right", &format!("{limit:.1}"));
    }
    let unit = if axis.is_stroke { "mm" } else { "°" };
    canvas.text([LEFT - 46.0, top + STRIP / 2.0 + 4.0], "label right", &format!("j{} ({unit})", index + 1));
    let position = |sample: &Sample| sample.joints.get(index).copied().unwrap_or_default();
    reference(picture, canvas, time, |sample| y(position(sample)));
    curve(picture, canvas, time, index, |_, sample| y(position(sample)));
}

/// The speed of each axis in per cent of the nominal one.
fn joint_speeds(picture: &Picture, canvas: &mut Canvas, time: &Time, top: f64) {
    let share = |axis: usize, before: &Sample, after: &Sample| {
        let nominal = picture.axes.get(axis).map_or(1.0, |axis| axis.nominal_speed);
        let [from, to] = [before, after].map(|sample| sample.joints.get(axis).copied().unwrap_or_default());
        let seconds = after.t - before.t;
        if seconds > 0.0 && nominal > 0.0 { (to - from).abs() / seconds / nominal * 100.0 } else { 0.0 }
    };
    let highest = picture.samples.windows(2).flat_map(|pair| {
        let axes = 0..picture.axes.len();
        axes.map(move |axis| if let [before, after] = pair { share(axis, before, after) } else { 0.0 })
    });
    let chart = Chart::new(canvas, time, top, highest.fold(100.0, f64::max), "joint speeds (% of nominal)");
    let limit = chart.y(100.0);
    canvas.rule([LEFT, limit], [RIGHT, limit], "limit");
    for (index, colour) in AXES.iter().enumerate().take(picture.axes.len()) {
        let x = LEFT + 260.0 + 42.0 * index as f64;
        canvas.text([x, top - 6.0], "label", &format!("j{}", index + 1));
        canvas.line([x + 16.0, top - 10.0], [x + 34.0, top - 10.0], &format!("stroke:{colour};stroke-width:2.5"));
        curve(picture, canvas, time, index, |before, after| chart.y(share(index, before, after)));
    }
}

/// The speed of the tool centre point.
fn tool_speed(picture: &Picture, canvas: &mut Canvas, time: &Time, top: f64) {
    let samples = picture.samples.iter().chain(&picture.reference);
    let highest = samples.map(|sample| sample.speed).fold(1.0, f64::max);
    let chart = Chart::new(canvas, time, top, highest, "speed of the tool centre point (mm/s)");
    reference(picture, canvas, time, |sample| chart.y(sample.speed));
    curve(picture, canvas, time, 0, |_, sample| chart.y(sample.speed));
}

/// A chart of speeds from 0 to a highest one.
struct Chart {
    bottom: f64,
    scale: f64,
}

impl Chart {
    fn new(canvas: &mut Canvas, time: &Time, top: f64, highest: f64, name: &str) -> Self {
        let bottom = top + SPEEDS;
        time.grid(canvas, [top, bottom]);
        canvas.text([LEFT, top - 6.0], "label", name);
        let chart = Self { bottom, scale: (SPEEDS - 8.0) / highest };
        let step = ticks::step(chart.scale, 26.0);
        for value in ticks::multiples(step, [0.0, highest]) {
            let y = chart.y(value);
            canvas.rule([LEFT, y], [RIGHT, y], "grid");
            canvas.text([LEFT - 6.0, y + 4.0], "tick right", &ticks::shown(value, step));
        }
        chart
    }

    fn y(&self, value: f64) -> f64 {
        self.bottom - value * self.scale
    }
}

/// A curve of each sample and the one before it.
fn curve(picture: &Picture, canvas: &mut Canvas, time: &Time, axis: usize, y: impl Fn(&Sample, &Sample) -> f64) {
    let samples = &picture.samples;
    let before = samples.iter().take(1).chain(samples);
    let points: Vec<_> = before.zip(samples).map(|(before, sample)| [time.x(sample.t), y(before, sample)]).collect();
    let colour = AXES.get(axis).copied().unwrap_or("#222");
    canvas.path(&thinned(&points), &format!("stroke:{colour};stroke-width:1.6"));
}

/// A curve of the recorded motion.
fn reference(picture: &Picture, canvas: &mut Canvas, time: &Time, y: impl Fn(&Sample) -> f64) {
    let points: Vec<_> = picture.reference.iter().map(|sample| [time.x(sample.t), y(sample)]).collect();
    canvas.path(&thinned(&points), REFERENCE);
}
