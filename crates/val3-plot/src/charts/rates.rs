//! Charts of speeds and accelerations over time.

use super::chart::{Chart, legend};
use super::time::{LEFT, Time};
use crate::canvas::Canvas;
use crate::colours::AXES;
use crate::in_force::{InForce, OnBlend};
use crate::{Picture, PictureAxis, Sample};

/// Height of a chart in pixels.
pub(super) const HEIGHT: f64 = 130.0;

/// Limits up to this multiple of the highest value are drawn.
const FAR: f64 = 2.0;

/// Ratio of the chart's range to its highest value, so that there is space for the name of the highest limit.
const HEADROOM: f64 = 1.12;

/// Share of a limit from which a value is at the limit, because the planner keeps a small distance between knots.
const TOUCH: f64 = 0.98;

/// A chart of rates.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Rate {
    /// Speeds of the axes.
    JointSpeed,
    /// Accelerations of the axes.
    JointAcceleration,
    /// Speed of the tool centre point.
    ToolSpeed,
    /// Rotation speed of the tool.
    ToolRotation,
}

impl Rate {
    /// Returns the charts of a picture, from top to bottom.
    pub(super) fn all(picture: &Picture) -> Vec<Self> {
        let mut rates = vec![Self::JointSpeed];
        rates.extend(picture.has_accelerations.then_some(Self::JointAcceleration));
        rates.push(Self::ToolSpeed);
        rates.extend(is_near_rotation_limit(picture).then_some(Self::ToolRotation));
        rates
    }

    /// Draws the chart from `top` on.
    pub(super) fn draw(self, picture: &Picture, canvas: &mut Canvas, time: &Time, top: f64) {
        match self {
            Self::JointSpeed => joint_speeds(picture, canvas, time, top),
            Self::JointAcceleration => joint_accelerations(picture, canvas, time, top),
            Self::ToolSpeed => tool_speed(picture, canvas, time, top),
            Self::ToolRotation => tool_rotation(picture, canvas, time, top),
        }
    }
}

/// Draws the axis speeds in % of the nominal speeds.
fn joint_speeds(picture: &Picture, canvas: &mut Canvas, time: &Time, top: f64) {
    let limits = InForce::of(picture, OnBlend::Smaller, |limits| limits.joint_speed);
    let curves: Vec<_> = picture.axes.iter().enumerate().map(|(index, axis)| speeds(picture, index, axis)).collect();
    let used = curves.iter().flatten().map(|(_, value)| *value).fold(10.0, f64::max);
    let chart = Chart::new(canvas, time, [top, top + HEIGHT], [0.0, highest(used, &limits)], 26.0);
    canvas.text([LEFT, top - 6.0], "label", "joint speeds (% of nominal)");
    axes(picture, canvas, top - 6.0);
    legend(canvas, top - 6.0);
    chart.limits(canvas, &limits, "vel", 1.0);
    for values in &curves {
        chart.at_limit(canvas, values, is_at(&limits));
    }
    for (values, colour) in curves.iter().zip(AXES) {
        chart.curve(canvas, colour, values.iter().copied());
    }
}

/// Draws the changes of the axis speeds: positive in % of the nominal acceleration, negative in % of the nominal
/// deceleration.
fn joint_accelerations(picture: &Picture, canvas: &mut Canvas, time: &Time, top: f64) {
    let [speeding, braking] = [
        InForce::of(picture, OnBlend::Nearer, |limits| limits.acceleration),
        InForce::of(picture, OnBlend::Nearer, |limits| limits.deceleration),
    ];
    let curves: Vec<_> =
        picture.axes.iter().enumerate().map(|(index, axis)| accelerations(picture, index, axis)).collect();
    let used = |sign: f64| curves.iter().flatten().map(|(_, value)| sign * value).fold(10.0, f64::max);
    let range = [-highest(used(-1.0), &braking), highest(used(1.0), &speeding)];
    let chart = Chart::new(canvas, time, [top, top + HEIGHT], range, 26.0);
    canvas.text([LEFT, top - 6.0], "label", "joint accelerations, decelerations below 0 (% of nominal)");
    chart.limits(canvas, &speeding, "accel", 1.0);
    chart.limits(canvas, &braking, "decel", -1.0);
    for (values, colour) in curves.iter().zip(AXES) {
        chart.curve(canvas, colour, values.iter().copied());
    }
}

/// Draws the speed of the tool centre point.
fn tool_speed(picture: &Picture, canvas: &mut Canvas, time: &Time, top: f64) {
    let limits = InForce::of(picture, OnBlend::Smaller, |limits| limits.tool_speed);
    let values: Vec<_> = picture.samples.iter().map(|sample| (sample.t, sample.speed)).collect();
    let used = picture.samples.iter().chain(&picture.reference).map(|sample| sample.speed).fold(1.0, f64::max);
    let chart = Chart::new(canvas, time, [top, top + HEIGHT], [0.0, highest(used, &limits)], 26.0);
    canvas.text([LEFT, top - 6.0], "label", "speed of the tool centre point (mm/s)");
    chart.limits(canvas, &limits, "tvel", 1.0);
    chart.reference(canvas, &picture.reference, |sample| sample.speed);
    chart.at_limit(canvas, &values, is_at(&limits));
    chart.curve(canvas, AXES[0], values.iter().copied());
}

/// Whether the rotation speed comes near the `rvel` of a move. If not, rotation is not drawn.
fn is_near_rotation_limit(picture: &Picture) -> bool {
    let limits = InForce::of(picture, OnBlend::Smaller, |limits| limits.tool_rotation);
    let used = picture.samples.iter().map(|sample| sample.rotation).fold(0.0, f64::max);
    limits.steps().iter().any(|step| step.value <= FAR * used)
}

/// Draws the rotation speed of the tool.
fn tool_rotation(picture: &Picture, canvas: &mut Canvas, time: &Time, top: f64) {
    let limits = InForce::of(picture, OnBlend::Smaller, |limits| limits.tool_rotation);
    let values: Vec<_> = picture.samples.iter().map(|sample| (sample.t, sample.rotation)).collect();
    let used = values.iter().map(|(_, value)| *value).fold(1.0, f64::max);
    let chart = Chart::new(canvas, time, [top, top + HEIGHT], [0.0, highest(used, &limits)], 26.0);
    canvas.text([LEFT, top - 6.0], "label", "rotation of the tool (°/s)");
    chart.limits(canvas, &limits, "rvel", 1.0);
    chart.at_limit(canvas, &values, is_at(&limits));
    chart.curve(canvas, AXES[0], values.iter().copied());
}

/// Draws the colours of the axes next to the name of a chart.
fn axes(picture: &Picture, canvas: &mut Canvas, y: f64) {
    for (index, colour) in AXES.iter().enumerate().take(picture.axes.len()) {
        let x = LEFT + 260.0 + 42.0 * index as f64;
        canvas.text([x, y], "label", &format!("j{}", index + 1));
        canvas.line([x + 16.0, y - 4.0], [x + 34.0, y - 4.0], &format!("stroke:{colour};stroke-width:2.5"));
    }
}

/// Returns the highest value of a chart's range. Limits far above the used range are not drawn.
fn highest(used: f64, limits: &InForce) -> f64 {
    let values = limits.steps().iter().map(|step| step.value);
    values.filter(|value| *value <= FAR * used).fold(used, f64::max) * HEADROOM
}

/// Whether a value is at the active limit.
fn is_at(limits: &InForce) -> impl Fn(f64, f64) -> bool {
    |t, value| limits.at(t).is_some_and(|limit| value >= TOUCH * limit)
}

/// Returns the axis speed before every sample, in % of the nominal speed.
fn speeds(picture: &Picture, index: usize, axis: &PictureAxis) -> Vec<(f64, f64)> {
    let share = |speed: f64| if axis.nominal_speed > 0.0 { speed.abs() / axis.nominal_speed * 100.0 } else { 0.0 };
    rates(picture, index).into_iter().map(|[t, _, speed]| (t, share(speed))).collect()
}

/// Returns the change of the axis speed at every sample: in % of the nominal acceleration, or negative in % of the
/// nominal deceleration.
fn accelerations(picture: &Picture, index: usize, axis: &PictureAxis) -> Vec<(f64, f64)> {
    let rates = rates(picture, index);
    rates.iter().zip(rates.iter().skip(1)).flat_map(|(before, after)| acceleration(before, after, axis)).collect()
}

/// Returns the acceleration at the first of two rates, after a zero if the axis has rested before.
fn acceleration(
    [t, before_length, before]: &[f64; 3],
    [_, length, after]: &[f64; 3],
    axis: &PictureAxis,
) -> impl Iterator<Item = (f64, f64)> + use<> {
    let seconds = before_length.min(*length);
    let change = if seconds > 0.0 { (after - before) / seconds } else { 0.0 };
    let is_faster = change * (before + after) >= 0.0;
    let (nominal, sign) = if is_faster { (axis.nominal_acceleration, 1.0) } else { (axis.nominal_deceleration, -1.0) };
    let value = (*t, if nominal > 0.0 { sign * change.abs() / nominal * 100.0 } else { 0.0 });
    // A rest has no samples. It ends in one cycle.
    let has_rested = *before_length > 2.0 * length;
    has_rested.then_some((*t, 0.0)).into_iter().chain([value])
}

/// Returns for each sample its time, the seconds since the previous sample, and the axis speed in this time, per
/// second.
fn rates(picture: &Picture, index: usize) -> Vec<[f64; 3]> {
    let samples = &picture.samples;
    let before = samples.iter().take(1).chain(samples);
    before.zip(samples).map(|(before, after)| rate(before, after, index)).collect()
}

fn rate(before: &Sample, after: &Sample, index: usize) -> [f64; 3] {
    let [from, to] = [before, after].map(|sample| sample.joints.get(index).copied().unwrap_or_default());
    let seconds = after.t - before.t;
    [after.t, seconds, if seconds > 0.0 { (to - from) / seconds } else { 0.0 }]
}

#[cfg(test)]
mod tests {
    use super::{accelerations, speeds};
    use crate::{MotionPhase, Picture, PictureAxis, Sample};

    #[test]
    fn rates_are_shares_of_the_nominal_ones() {
        let axis = PictureAxis {
            is_stroke: false,
            min: -180.0,
            max: 180.0,
            nominal_speed: 200.0,
            nominal_acceleration: 1000.0,
            nominal_deceleration: 2000.0,
        };
        let samples = vec![sample(0.0, 0.0), sample(0.01, 0.1), sample(0.02, 0.3), sample(0.03, 0.3)];
        let picture = Picture { samples, axes: vec![axis.clone()], ..Picture::default() };
        let rounded = |values: Vec<(f64, f64)>| values.into_iter().map(|(_, value)| value.round()).collect::<Vec<_>>();
        assert_eq!(rounded(speeds(&picture, 0, &axis)), [0.0, 5.0, 10.0, 0.0]);
        assert_eq!(rounded(accelerations(&picture, 0, &axis)), [0.0, 100.0, -100.0]);
        let mut later = picture.clone();
        later.samples.iter_mut().skip(1).for_each(|sample| sample.t += 1.0);
        later.samples[1].joints = [0.0; 6];
        assert_eq!(rounded(accelerations(&later, 0, &axis)), [0.0, 0.0, 300.0, -150.0]);
    }

    /// Returns a sample with the negative position on each axis.
    fn sample(t: f64, position: f64) -> Sample {
        Sample {
            t,
            joints: [-position; 6],
            position: [0.0; 3],
            speed: 0.0,
            rotation: 0.0,
            phase: MotionPhase::Nominal,
            limit: None,
        }
    }
}
