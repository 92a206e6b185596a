//! Configuration along a Cartesian path. A path exactly through a singular position may change the configuration
//! (manual 10.1.4.2, section (k) of the motion model).

use val3_geometry::degrees;
use val3_kinematics::{Arm, Configuration, ConfigurationRequest, Elbow, RequestedConfiguration, Shoulder, Wrist};

use crate::fault::Cause;
use crate::model::Axes;

/// Distance from a singular position below which the arm counts as singular: a sine, or a fraction of the arm's reach.
const SINGULAR: f64 = 1e-6;

/// Distance from a change, as a fraction of the path, within which the axes are interpolated because one axis is
/// undetermined at the change.
const NEAR: f64 = 1e-6;

/// Distance from a change, as a fraction of the path, at which both possible continuations are compared.
const PROBE: f64 = 1e-4;

/// Maximum deviation of a continuation from the extrapolated axes, in degrees.
const BEND: f64 = 1.0;

/// Steps of the search for the point nearest to a singular position.
const SEARCH: usize = 80;

/// Part of the configuration.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ConfigurationPart {
    Shoulder,
    Elbow,
    Wrist,
}

impl ConfigurationPart {
    /// Parts of the configuration that a destination does not prescribe.
    pub(crate) fn free(requested: &RequestedConfiguration) -> impl Iterator<Item = Self> + use<> {
        let parts = [
            (Self::Shoulder, requested.shoulder == ConfigurationRequest::Free),
            (Self::Elbow, requested.elbow == ConfigurationRequest::Free),
            (Self::Wrist, requested.wrist == ConfigurationRequest::Free),
        ];
        parts.into_iter().filter_map(|(part, is_free)| is_free.then_some(part))
    }

    /// Distance from the singular position in which this part changes: a sine, or a fraction of the arm's reach.
    pub(crate) fn distance(self, arm: &Arm, axes: &Axes) -> f64 {
        let sine = |axis: usize| axes.get(axis).map_or(f64::INFINITY, |angle| degrees::sin(*angle).abs());
        match self {
            Self::Shoulder if arm.is_scara() => sine(1),
            Self::Shoulder => {
                let dh = arm.dh();
                let [a1, c2, c3] = [dh.a[0], dh.a[1], dh.d[3]];
                let [j2, j3] = [axes[1], axes[2]];
                let radial = a1 + c2 * degrees::sin(j2) + c3 * degrees::sin(j2 + j3);
                radial.abs() / (c2 + c3)
            }
            _ if arm.is_scara() => f64::INFINITY,
            Self::Elbow => sine(2),
            Self::Wrist => sine(4),
        }
    }

    /// Whether the arm may pass the singular position of this part within two steps of a path, after `before` and
    /// `near`.
    pub(crate) fn may_change(self, arm: &Arm, before: Option<&Axes>, near: &Axes) -> bool {
        let distance = self.distance(arm, near);
        let approached = before.map_or(0.0, |before| self.distance(arm, before) - distance);
        distance < SINGULAR || distance <= 2.0 * approached
    }

    fn changed(self, branch: Configuration) -> Configuration {
        match self {
            Self::Shoulder => {
                let shoulder = match branch.shoulder {
                    Shoulder::Lefty => Shoulder::Righty,
                    Shoulder::Righty => Shoulder::Lefty,
                };
                Configuration { shoulder, ..branch }
            }
            Self::Elbow => {
                let elbow = match branch.elbow {
                    Elbow::Positive => Elbow::Negative,
                    Elbow::Negative => Elbow::Positive,
                };
                Configuration { elbow, ..branch }
            }
            Self::Wrist => {
                let wrist = match branch.wrist {
                    Wrist::Positive => Wrist::Negative,
                    Wrist::Negative => Wrist::Positive,
                };
                Configuration { wrist, ..branch }
            }
        }
    }
}

/// Configuration by σ.
#[derive(Clone, Debug)]
pub(crate) struct Branches {
    start: Configuration,
    /// Configuration changes with their σ, in ascending order.
    changes: Vec<(f64, Configuration)>,
}

/// Solver for the axes of a path at σ on a branch, near to other axes.
pub(crate) trait Solve: Fn(Configuration, f64, &Axes) -> Result<Axes, Cause> {}

impl<F: Fn(Configuration, f64, &Axes) -> Result<Axes, Cause>> Solve for F {}

impl Branches {
    pub(crate) fn starting_on(start: Configuration) -> Self {
        Self { start, changes: Vec::new() }
    }

    /// Axes at σ.
    pub(crate) fn axes(&self, solve: impl Solve, sigma: f64, near: &Axes) -> Result<Axes, Cause> {
        let Some((change, _)) = self.changes.iter().find(|(change, _)| (sigma - change).abs() < NEAR) else {
            return solve(self.at(sigma), sigma, near);
        };
        let [before, after] = [(change - NEAR).max(0.0), (change + NEAR).min(1.0)];
        let before_axes = solve(self.before(*change), before, near)?;
        let after_axes = solve(self.at(after), after, near)?;
        Ok(before_axes + (after_axes - before_axes) * ((sigma - before) / (after - before)))
    }

    fn at(&self, sigma: f64) -> Configuration {
        self.changes.iter().rev().find(|(change, _)| *change <= sigma).map_or(self.start, |(_, branch)| *branch)
    }

    fn before(&self, sigma: f64) -> Configuration {
        self.changes.iter().rev().find(|(change, _)| *change < sigma).map_or(self.start, |(_, branch)| *branch)
    }

    /// Searches for a change of a part between two values of σ. `near` are the axes at the first value.
    pub(crate) fn look_for(
        &mut self,
        part: ConfigurationPart,
        arm: &Arm,
        solve: impl Solve,
        [from, to]: [f64; 2],
        near: &Axes,
    ) {
        if self.changes.last().is_some_and(|(change, _)| *change > from - PROBE) {
            return;
        }
        let branch = self.at(from);
        let search = ChangeSearch { part, arm, solve, near, branch, other: part.changed(branch) };
        let change = lowest(from, to, |sigma| search.distance(sigma));
        if search.distance(change) < SINGULAR && search.continues_on_other(change) {
            self.changes.push((change, search.other));
        }
    }
}

/// Search for a singular position at which the path changes from one branch to another.
struct ChangeSearch<'s, S> {
    /// Part in which the branches differ.
    part: ConfigurationPart,
    arm: &'s Arm,
    solve: S,
    /// Axes at the start of the searched section.
    near: &'s Axes,
    branch: Configuration,
    other: Configuration,
}

impl<S: Solve> ChangeSearch<'_, S> {
    /// Distance from the singular position at σ; infinite if the axes have no solution on either branch.
    fn distance(&self, sigma: f64) -> f64 {
        let Self { part, arm, solve, near, branch, other } = self;
        let axes = solve(*branch, sigma, near).or_else(|_| solve(*other, sigma, near));
        axes.map_or(f64::INFINITY, |axes| part.distance(arm, &axes))
    }

    /// Whether the axes continue smoothly beyond the singular position on the other branch, and not on the present one.
    fn continues_on_other(&self, change: f64) -> bool {
        let Self { solve, near, branch, other, .. } = self;
        let after = change + PROBE;
        let expected = if change < 2.0 * PROBE {
            Ok(**near)
        } else {
            let [first, second] = [change - 2.0 * PROBE, change - PROBE].map(|sigma| solve(*branch, sigma, near));
            first.and_then(|first| second.map(|second| second + (second - first) * 2.0))
        };
        let Ok(expected) = expected else { return false };
        let bend = |branch| solve(branch, after, &expected).map_or(f64::INFINITY, |axes| (axes - expected).amax());
        after <= 1.0 && bend(*other) < BEND.min(bend(*branch) / 2.0)
    }
}

/// Minimum point of a function that decreases and then increases (golden-section search).
fn lowest(mut from: f64, mut to: f64, value: impl Fn(f64) -> f64) -> f64 {
    const SHARE: f64 = 0.618_033_988_749_894_8;
    let inner = |from: f64, to: f64| [to - (to - from) * SHARE, from + (to - from) * SHARE];
    let [mut left, mut right] = inner(from, to);
    let [mut at_left, mut at_right] = [value(left), value(right)];
    for _ in 0..SEARCH {
        if at_left <= at_right {
            (to, right, at_right) = (right, left, at_left);
            left = inner(from, to)[0];
            at_left = value(left);
        } else {
            (from, left, at_left) = (left, right, at_right);
            right = inner(from, to)[1];
            at_right = value(right);
        }
    }
    if at_left <= at_right { left } else { right }
}
