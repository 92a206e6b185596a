//! Hull of nominal pieces in joint space, within which a joint blend stays.

use crate::model::{Axes, Model};
use crate::segment::Segment;

/// Number of parts into which a Cartesian piece is divided to compute its axes.
const PARTS: u32 = 16;

/// Distance by which a control point may be outside of the hull, relative to the longest side of the hull, because an
/// axis with a small motion may reverse slightly later.
pub(crate) const MARGIN: f64 = 0.02;

/// Tolerance for every axis, in degrees or mm, because at a limit the derivatives of a resting axis are noise.
const ROUNDING: f64 = 1e-9;

/// Minimum rate: with a rate of 0 the path would have no direction.
const LEAST_RATE: f64 = 1e-6;

/// Axis ranges on the nominal pieces of a corner.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Hull {
    least: Axes,
    most: Axes,
}

impl Hull {
    /// Computes the hull of segment pieces, each given by its range of σ. A margin is added within the arm's limits.
    pub(crate) fn of_pieces(model: &Model<'_>, pieces: [(&Segment, [f64; 2]); 2]) -> Self {
        let mut hull = Self { least: Axes::repeat(f64::INFINITY), most: Axes::repeat(f64::NEG_INFINITY) };
        for (segment, [from, to]) in pieces {
            let parts = if segment.is_straight_in_joints() { 1 } else { PARTS };
            for part in 0..=parts {
                let sigma = from + (to - from) * f64::from(part) / f64::from(parts);
                // The arm need not be able to reach the corner, because the blend avoids it.
                if let Ok(axes) = segment.axes(model, sigma) {
                    (hull.least, hull.most) = (hull.least.inf(&axes), hull.most.sup(&axes));
                }
            }
        }
        let margin = MARGIN * (hull.most - hull.least).amax();
        let [least, most] = model.limits();
        Self {
            least: hull.least.zip_map(&least, |hull, limit| hull.min((hull - margin).max(limit))),
            most: hull.most.zip_map(&most, |hull, limit| hull.max((hull + margin).min(limit))),
        }
    }

    /// Greatest rate, at most 1, for which the control points next to `value` are within the hull.
    ///
    /// `first` and `second` are the derivatives for a rate of 1, by a parameter that runs from `value` to the corner.
    pub(crate) fn greatest_rate(&self, value: &Axes, first: &Axes, second: &Axes) -> f64 {
        let room = [self.most - value, value - self.least].map(|room| room.add_scalar(ROUNDING));
        let rates = room.iter().zip([1.0, -1.0]).flat_map(|(room, sign)| {
            (0..value.len()).map(move |axis| {
                let at = |vector: &Axes| vector.get(axis).copied().unwrap_or_default();
                let (room, first, second) = (at(room), sign * at(first), sign * at(second));
                first_exit(0.8 * first, 0.2 * second, room).min(first_exit(0.4 * first, 0.0, room))
            })
        });
        rates.fold(1.0, f64::min).max(LEAST_RATE)
    }
}

/// Smallest k > 0 with `linear`·k + `square`·k² = `room`, for `room` ≥ 0; infinite if none exists.
fn first_exit(linear: f64, square: f64, room: f64) -> f64 {
    let discriminant = linear * linear + 4.0 * square * room;
    // This form of the smaller positive root is exact if `square` is close to 0.
    let divisor = linear + discriminant.sqrt();
    if divisor > 0.0 { 2.0 * room / divisor } else { f64::INFINITY }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_exit_is_the_smaller_root() {
        assert!((first_exit(2.0, 0.0, 1.0) - 0.5).abs() < 1e-12);
        assert!((first_exit(3.0, -1.0, 2.0) - 1.0).abs() < 1e-12);
        assert!((first_exit(-1.0, 1.0, 2.0) - 2.0).abs() < 1e-12);
        assert_eq!(first_exit(1.0, -1.0, 1.0), f64::INFINITY);
        assert_eq!(first_exit(-1.0, -1.0, 1.0), f64::INFINITY);
        assert_eq!(first_exit(0.0, 0.0, 1.0), f64::INFINITY);
    }

    #[test]
    fn an_axis_that_is_locally_fast_reduces_the_rate() {
        let hull = Hull { least: Axes::zeros(), most: Axes::repeat(10.0) };
        let at = |axis: f64| Axes::new(axis, 0.0, 0.0, 0.0, 0.0, 0.0);
        assert_eq!(hull.greatest_rate(&Axes::zeros(), &at(10.0), &Axes::zeros()), 1.0);
        assert!((hull.greatest_rate(&Axes::zeros(), &at(1000.0), &Axes::zeros()) - 0.0125).abs() < 1e-9);
    }
}
