//! Active limits of motion descriptors over time.

use crate::{MoveLimits, Picture};

/// A constant limit during a part of the motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct LimitStep {
    /// Beginning in seconds.
    pub(crate) from: f64,
    /// End in seconds.
    pub(crate) to: f64,
    /// Value of the limit.
    pub(crate) value: f64,
}

/// A limit over time. There is no limit while no move is executed.
pub(crate) struct InForce(Vec<LimitStep>);

/// Rule for the limit on the blend between two moves.
#[derive(Clone, Copy)]
pub(crate) enum OnBlend {
    /// The smaller limit is used, as for speeds.
    Smaller,
    /// The limit of the nearer move is used, as for accelerations.
    Nearer,
}

impl InForce {
    /// Returns a limit of the moves over time.
    pub(crate) fn of(picture: &Picture, on_blend: OnBlend, limit: impl Fn(&MoveLimits) -> f64) -> Self {
        let mut limits = Self(Vec::new());
        let end = picture.samples.last().map_or(0.0, |last| last.t);
        for (index, mark) in picture.moves.iter().enumerate() {
            let (Some(started), Some(own)) = (mark.started, mark.limits.as_ref().map(&limit)) else { continue };
            let ended = mark.ended.unwrap_or(end);
            let next = picture.moves.get(index + 1).and_then(|next| next.limits.as_ref()).map(&limit);
            let (Some(blended), Some(next)) = (mark.blended, next) else {
                limits.push(LimitStep { from: started, to: ended, value: own });
                continue;
            };
            let (changes, value) = match on_blend {
                OnBlend::Smaller => (blended, own.min(next)),
                OnBlend::Nearer => ((blended + ended) / 2.0, next),
            };
            limits.push(LimitStep { from: started, to: changes, value: own });
            limits.push(LimitStep { from: changes, to: ended, value });
        }
        limits
    }

    /// Adds a step. If its limit equals the last limit, the last step is extended.
    fn push(&mut self, step: LimitStep) {
        if step.to <= step.from || !step.value.is_finite() {
            return;
        }
        match self.0.last_mut() {
            Some(last) if last.to >= step.from && last.value == step.value => last.to = step.to,
            _ => self.0.push(step),
        }
    }

    /// Returns the steps sorted by time.
    pub(crate) fn steps(&self) -> &[LimitStep] {
        &self.0
    }

    /// Returns the limit at a time in seconds.
    pub(crate) fn at(&self, t: f64) -> Option<f64> {
        let begun = self.0.partition_point(|step| step.from <= t);
        self.0.get(begun.checked_sub(1)?).filter(|step| t <= step.to).map(|step| step.value)
    }
}

#[cfg(test)]
mod tests {
    use super::{InForce, OnBlend};
    use crate::{MoveLimits, MoveMark, Picture};

    fn limits(on_blend: OnBlend) -> InForce {
        let moves = vec![
            mark(400.0, [Some(0.0), Some(1.0), Some(1.2)]),
            mark(250.0, [Some(1.2), None, Some(2.0)]),
            mark(250.0, [Some(5.0), None, Some(6.0)]),
            mark(900.0, [None; 3]),
        ];
        InForce::of(&Picture { moves, ..Picture::default() }, on_blend, |limits| limits.tool_speed)
    }

    /// Returns a move with the times at which it starts, begins its blend and ends.
    fn mark(tool_speed: f64, [started, blended, ended]: [Option<f64>; 3]) -> MoveMark {
        let limits = MoveLimits {
            joint_speed: 100.0,
            acceleration: 100.0,
            deceleration: 100.0,
            tool_speed,
            tool_rotation: 9999.0,
        };
        MoveMark { limits: Some(limits), started, blended, ended, ..MoveMark::default() }
    }

    #[test]
    fn the_smaller_speed_counts_on_a_blend() {
        let limits = limits(OnBlend::Smaller);
        let steps: Vec<_> = limits.steps().iter().map(|step| [step.from, step.to, step.value]).collect();
        assert_eq!(steps, [[0.0, 1.0, 400.0], [1.0, 2.0, 250.0], [5.0, 6.0, 250.0]]);
        assert_eq!(
            [0.5, 1.1, 3.0, 5.0, 7.0].map(|t| limits.at(t)),
            [Some(400.0), Some(250.0), None, Some(250.0), None]
        );
    }

    #[test]
    fn the_acceleration_of_the_nearer_move_counts_on_a_blend() {
        let limits = limits(OnBlend::Nearer);
        assert_eq!([1.09, 1.11].map(|t| limits.at(t)), [Some(400.0), Some(250.0)]);
    }
}
