//! The motion of one arm: records moves, plans them, and executes them.

use std::sync::Arc;

use val3_geometry::IsometryMatrix3;
use val3_kinematics::{Arm, Joints};

use crate::executor::Executor;
use crate::fault::Cause;
use crate::model::{Axes, Model};
use crate::path::{Determined, Path};
use crate::request::Move;
use crate::timeline::Timeline;
use crate::units::{MillimetresPerSecond, Percent, Seconds};

/// A queue of moves with the state of their execution: plain data, so that a copy is a snapshot.
#[derive(Clone, Debug)]
pub struct Motion {
    arm: Arc<Arm>,
    path: Path,
    timeline: Timeline,
    executor: Executor,
    /// Why the recorded path cannot be followed to its end.
    fault: Option<Cause>,
    /// Where the arm rests while nothing is recorded.
    rest: Axes,
    /// `getMoveId` once everything recorded is done.
    done_id: f64,
    tool: IsometryMatrix3<f64>,
    /// Of the tool centre point over the last cycle, in mm/s.
    speed: f64,
    /// Between `stopMove` and `restartMove`.
    is_stopped: bool,
}

/// The commanded state at the end of a cycle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// Commanded joint position.
    pub joints: Joints,
    /// The tool centre point in world.
    pub pose: IsometryMatrix3<f64>,
    /// Speed of the tool centre point over the last cycle.
    pub speed: MillimetresPerSecond,
    /// `getMoveId`.
    pub id: f64,
    /// The kind of motion.
    pub phase: Phase,
}

/// The kind of motion in a cycle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Phase {
    /// It follows the path that a move describes.
    Nominal,
    /// It rounds a corner.
    Blend,
    /// It brakes on its path.
    Stopping,
    /// It rests: nothing more is determined, or it is stopped.
    Waiting,
}

impl Motion {
    /// An arm that rests at these joints.
    #[must_use]
    pub fn new(arm: Arc<Arm>, start: Joints) -> Self {
        Self {
            arm,
            path: Path::starting_at(start.into()),
            timeline: Timeline::default(),
            executor: Executor::default(),
            fault: None,
            rest: start.into(),
            done_id: 0.0,
            tool: IsometryMatrix3::identity(),
            speed: 0.0,
            is_stopped: false,
        }
    }

    /// Records a move.
    ///
    /// # Errors
    /// The destination cannot be reached, or the path recorded before cannot be followed.
    pub fn record(&mut self, request: &Move) -> Result<(), Cause> {
        self.check()?;
        let determined = self.path.record(&Model(&self.arm), request)?;
        self.append(determined);
        self.done_id = request.id + 1.0;
        Ok(())
    }

    /// Lets the last recorded move end at its destination (`waitEndMove`).
    ///
    /// # Errors
    /// The recorded path cannot be followed.
    pub fn close(&mut self) -> Result<(), Cause> {
        self.check()?;
        let determined = self.path.close(&Model(&self.arm));
        self.append(determined);
        self.check()
    }

    /// Whether everything recorded is done (`isEmpty`).
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.timeline.is_at_end() && !self.path.is_open()
    }

    /// Brakes on the path, and stays there until a restart (`stopMove`).
    pub fn stop(&mut self) {
        self.timeline.halt();
        self.is_stopped = true;
    }

    /// Continues after a stop (`restartMove`). Without one it does nothing.
    pub fn restart(&mut self) {
        if std::mem::take(&mut self.is_stopped) {
            self.timeline.release();
        }
    }

    /// Brakes on the path and forgets everything recorded (`resetMotion`). The next move starts where the arm comes to rest.
    pub fn reset(&mut self) {
        self.timeline.cut();
        self.timeline.spans.iter_mut().for_each(|span| span.is_forgotten = true);
        let end = self.timeline.spans.back().zip(self.timeline.end());
        let rest = end.map_or(self.rest, |(last, p)| last.span.axes(&Model(&self.arm), p));
        self.path = Path::starting_at(rest);
        (self.fault, self.done_id, self.is_stopped) = (None, 0.0, false);
    }

    /// Why the recorded path cannot be followed to its end. The next move is refused for it.
    #[must_use]
    pub const fn fault(&self) -> Option<&Cause> {
        self.fault.as_ref()
    }

    /// Where the last recorded move ends, and the next one begins.
    #[must_use]
    pub fn destination(&self) -> Joints {
        self.path.destination().into()
    }

    /// Puts the arm, with another geometry perhaps, at these joints. Everything recorded is forgotten.
    pub fn place(&mut self, arm: Arc<Arm>, joints: Joints) {
        let Self { executor, done_id, is_stopped, .. } = *self;
        *self = Self { executor, done_id, is_stopped, ..Self::new(arm, joints) };
    }

    /// Chooses the monitor speed.
    pub fn set_monitor_speed(&mut self, speed: Percent) {
        let at_rest = self.timeline.rate() == 0.0;
        self.executor.set_monitor_speed(speed, at_rest);
    }

    /// Moves on by a duration, one cycle of 4 ms as a rule.
    pub fn advance(&mut self, duration: Seconds) -> Sample {
        let tip = |motion: &Self| Model(&motion.arm).flange(&motion.axes()) * motion.tool;
        if let Some(front) = self.timeline.spans.front() {
            self.tool = front.span.tool;
        }
        let before = tip(self);
        let moved = !self.is_at_halt() && self.executor.advance(&mut self.timeline, duration);
        let pose = tip(self);
        let way = (pose.translation.vector - before.translation.vector).norm();
        self.speed = if duration.0 > 0.0 { way / duration.0 } else { self.speed };
        let phase = if moved { self.phase() } else { Phase::Waiting };
        Sample { joints: self.joints(), pose, speed: MillimetresPerSecond(self.speed), id: self.move_id(), phase }
    }

    /// Commanded joint position.
    #[must_use]
    pub fn joints(&self) -> Joints {
        self.axes().into()
    }

    /// `getMoveId` (section (b) of the motion model).
    #[must_use]
    pub fn move_id(&self) -> f64 {
        match (self.timeline.spans.front(), self.timeline.p()) {
            (Some(front), _) if front.is_forgotten && !self.timeline.is_at_end() => 0.0,
            (Some(front), Some(p)) if !self.is_empty() => front.span.part.id_at(p),
            _ => self.done_id,
        }
    }

    /// Time until the end of what is determined, at full monitor speed.
    #[must_use]
    pub fn time_left(&self) -> Seconds {
        Seconds(self.timeline.seconds_left())
    }

    /// Whether a cycle would move the arm, if the monitor speed is above 0.
    #[must_use]
    pub fn is_going(&self) -> bool {
        !self.timeline.is_at_end() && !self.is_at_halt()
    }

    /// Whether a stop has brought the arm to rest.
    fn is_at_halt(&self) -> bool {
        self.is_stopped && self.timeline.rate() == 0.0
    }

    fn axes(&self) -> Axes {
        match (self.timeline.spans.front(), self.timeline.p()) {
            (Some(front), Some(p)) => front.span.axes(&Model(&self.arm), p),
            _ => self.rest,
        }
    }

    fn phase(&self) -> Phase {
        match self.timeline.spans.front() {
            _ if self.is_stopped => Phase::Stopping,
            Some(front) if front.is_forgotten => Phase::Stopping,
            Some(front) if front.span.is_blend() => Phase::Blend,
            _ => Phase::Nominal,
        }
    }

    fn append(&mut self, determined: Determined) {
        for (span, from_rest) in determined.spans {
            self.timeline.append(span, from_rest);
        }
        self.fault = determined.fault;
    }

    fn check(&self) -> Result<(), Cause> {
        self.fault.clone().map_or(Ok(()), Err)
    }
}

#[cfg(test)]
mod tests;
