//! Arm motion: recording, planning and execution of moves.

mod alter;
mod holds;
mod jog;
mod limiting;
mod reduced;
mod stepping;
mod way;

pub use self::jog::Jog;
pub use self::stepping::{MotionMode, PathPiece, PieceEnd, PieceKind};
pub use self::way::PieceAhead;

use std::borrow::Cow;
use std::sync::Arc;

use val3_geometry::IsometryMatrix3;
use val3_kinematics::{Arm, Joints};
use val3_moves::{Manner, MillimetresPerSecond, MotionPhase, MovePath, Percent, Seconds};

use crate::alteration::Alteration;
use crate::compliant::{ExternalForce, Forces, Glide};
use crate::deferred::{Deferred, DeferredRequest};
use crate::departure::{self, Connection, Departure};
use crate::executor::{Advance, Executor};
use crate::fault::{Cause, PathFault};
use crate::model::{Axes, Model};
use crate::path::{Determined, PathEnd};
use crate::queue::{MoveEvent, Queue, QueuedMove};
use crate::request::Move;
use crate::speed_limit::{ActingLimit, SpeedLimit};
use crate::timeline::Timeline;

/// Queue of moves with the state of their execution. All fields are plain data, so a clone is a snapshot.
#[derive(Clone, Debug)]
pub struct Motion {
    arm: Arc<Arm>,
    path: PathEnd,
    timeline: Timeline,
    executor: Executor,
    mode: MotionMode,
    queue: Queue,
    /// See [`Motion::revision`].
    revision: u64,
    /// Fault of the recorded path.
    fault: Option<PathFault>,
    /// Rest position of the arm while no move is recorded.
    rest: Axes,
    /// Result of `getMoveId` when all recorded moves are done.
    done_id: f64,
    tool: IsometryMatrix3<f64>,
    /// State of the arm while it is not on its path; `None` on the path.
    departure: Option<Departure>,
    /// Speed of the tool centre point over the last cycle, in mm/s.
    speed: f64,
    /// Whether the motion is between `stopMove` and `restartMove`.
    is_stopped: bool,
    /// Whether the motion is between an emergency stop and the return of power.
    is_braked: bool,
    external_force: ExternalForce,
    /// Maximum speed of the tool centre point and of the flange; `None` without a limit.
    tool_speed: Option<MillimetresPerSecond>,
    /// Deviation from an alterable path (alter mode).
    alteration: Option<Alteration>,
    deferred: Option<Deferred>,
    /// Commanded state at the end of the last cycle.
    commanded: Axes,
    /// See [`Motion::speed_limit`].
    acting: ActingLimit,
}

/// Commanded state at the end of a cycle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// Commanded joint position.
    pub joints: Joints,
    /// Tool centre point in `world`.
    pub pose: IsometryMatrix3<f64>,
    /// Speed of the tool centre point over the last cycle.
    pub speed: MillimetresPerSecond,
    /// Result of `getMoveId`.
    pub id: f64,
    /// Motion phase.
    pub phase: MotionPhase,
}

impl Motion {
    /// Creates a motion whose arm rests at these joints.
    #[must_use]
    pub fn new(arm: Arc<Arm>, start: Joints) -> Self {
        Self {
            arm,
            path: PathEnd::starting_at(start.into()),
            timeline: Timeline::default(),
            executor: Executor::default(),
            mode: MotionMode::default(),
            queue: Queue::default(),
            revision: 0,
            fault: None,
            rest: start.into(),
            done_id: 0.0,
            tool: IsometryMatrix3::identity(),
            departure: None,
            speed: 0.0,
            is_stopped: false,
            is_braked: false,
            external_force: ExternalForce::default(),
            tool_speed: None,
            alteration: None,
            deferred: None,
            commanded: start.into(),
            acting: ActingLimit::Known(SpeedLimit::End),
        }
    }

    /// Records a move.
    ///
    /// # Errors
    /// Returns the cause if the destination cannot be reached, the arm cannot follow the line or circle to the
    /// destination, or the path recorded earlier already has a fault. The queue is then unchanged.
    pub fn record(&mut self, request: &Move) -> Result<(), Cause> {
        self.check()?;
        let request = &*self.with_joints(request)?;
        if self.tail().is_open() && matches!(request.manner, Manner::Compliant(_)) {
            return Err(Cause::BlendBeforeCompliant);
        }
        let serial = self.queue.next_serial();
        let determined = if self.must_wait(request) {
            self.defer(request, serial)?;
            Determined::default()
        } else {
            self.determine_or_reject(request, serial)?
        };
        let destination = self.tail().destination();
        let target = Model(&self.arm).flange(&destination) * request.tool;
        self.queue.record(request, target, destination.into());
        self.revision += 1;
        self.queue.lay_out(serial, determined.reach, determined.leave);
        self.append(determined, serial);
        self.done_id = request.id + 1.0;
        Ok(())
    }

    /// Returns the move, with the point of a joint move replaced by a joint position. A deferred move keeps this joint
    /// position, independently of its later start.
    fn with_joints<'a>(&self, request: &'a Move) -> Result<Cow<'a, Move>, Cause> {
        let MovePath::JointToPoint(target) = &request.path else { return Ok(Cow::Borrowed(request)) };
        let joints = self.tail().joints_at(&Model(&self.arm), target, &request.tool)?;
        Ok(Cow::Owned(Move { path: MovePath::Joint(joints), ..request.clone() }))
    }

    /// Determines the path of a move. A fault in the result is always a fault of the blend before the move.
    ///
    /// # Errors
    /// Returns the cause if the destination cannot be reached, or if the arm cannot follow the line or circle (manual
    /// 10.6). The path is then unchanged.
    fn determine_or_reject(&mut self, request: &Move, serial: u64) -> Result<Determined, Cause> {
        let path = self.path.clone();
        let determined = self.determine(request, serial)?;
        match &determined.fault {
            Some(cause) if !determined.has_blend_fault => {
                self.path = path;
                Err(cause.clone())
            }
            _ => Ok(determined),
        }
    }

    /// Ends the last recorded move at its destination, without a blend (`waitEndMove`).
    ///
    /// # Errors
    /// Returns the fault of the recorded path.
    pub fn close(&mut self) -> Result<(), Cause> {
        self.check()?;
        if let Some(deferred) = &mut self.deferred {
            if deferred.nominal.is_open() {
                deferred.nominal.close(&Model(&self.arm));
                deferred.requests.push_back(DeferredRequest::Close);
            }
            return Ok(());
        }
        self.close_path();
        self.check()
    }

    fn close_path(&mut self) {
        let last = self.path.open_serial();
        let requested = self.path.open_distances();
        let determined = self.path.close(&Model(&self.arm));
        self.queue.close(requested);
        self.append(determined, last.unwrap_or_default());
    }

    /// Whether all recorded moves are done (`isEmpty`).
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.is_nominal_done() && self.deferred.is_none() && self.fault.is_none()
    }

    /// Motion of the arm while it is not on its path.
    fn moving_away(&mut self) -> Option<&mut Self> {
        self.departure.as_mut().and_then(Departure::motion)
    }

    /// Brakes on the path and removes all recorded moves (`resetMotion`). The next move starts at the point where the
    /// arm comes to rest.
    pub fn reset(&mut self) {
        self.queue.forget();
        match self.departure.take() {
            None => self.cut(),
            Some(Departure::At(axes)) => {
                (self.timeline, self.rest, self.alteration) = (Timeline::default(), axes, None)
            }
            Some(Departure::Braking(motion) | Departure::Connecting(motion)) => {
                (self.timeline, self.executor, self.rest) = (motion.timeline, motion.executor, motion.rest);
                self.alteration = motion.alteration;
                self.cut();
            }
        }
        self.timeline.spans.iter_mut().for_each(|span| span.is_forgotten = true);
        let end = self.timeline.spans.back().zip(self.timeline.end());
        let rest = end.map_or(self.rest, |(last, p)| last.span.axes(&Model(&self.arm), p));
        self.path = PathEnd::starting_at(rest);
        self.reset_alteration();
        (self.fault, self.done_id, self.is_stopped) = (None, 0.0, false);
    }

    /// Brakes on the path and discards the rest of the path.
    fn cut(&mut self) {
        if self.timeline.compliant().is_some() {
            self.rest = self.axes_on_path();
            self.timeline = Timeline::default();
        }
        self.halt_as_planned();
        self.timeline.cut();
    }

    /// Resets as [`Motion::reset`] does, but the next move starts at `start`. The arm first needs a connection move to
    /// `start`.
    pub fn reset_to(&mut self, start: Joints) {
        self.reset();
        let mut left = Self { timeline: std::mem::take(&mut self.timeline), ..self.clone() };
        left.departure = None;
        self.alteration = None;
        (self.rest, self.path) = (start.into(), PathEnd::starting_at(start.into()));
        self.departure = Some(Departure::Braking(Box::new(left)));
        self.settle_departure();
    }

    /// Puts the arm at a position away from its path, as an operator does by hand. If no move is pending, the next move
    /// begins at this position. Has no effect while the arm moves on its path.
    pub fn displace(&mut self, joints: Joints) {
        if self.timeline.rate() > 0.0 || self.is_going() {
            return;
        }
        if self.is_empty() && self.departure.is_none() && self.alteration.is_none() {
            (self.rest, self.timeline) = (joints.into(), Timeline::default());
            self.path = PathEnd::starting_at(self.rest);
        } else {
            self.departure = Departure::at(joints.into(), &self.axes_on_path());
        }
        self.commanded = self.axes();
    }

    /// Connection move that the arm needs; `None` unless the arm rests away from its path.
    #[must_use]
    pub fn connection(&self) -> Option<Connection> {
        let Some(Departure::At(axes)) = &self.departure else { return None };
        let connection = Connection::between(&Model(&self.arm), axes, &self.axes_on_path(), &self.tool);
        Some(connection).filter(Connection::is_needed)
    }

    /// Starts the connection move to the path if the arm rests away from the path.
    ///
    /// # Errors
    /// Returns the cause if the start of the path is outside an axis limit.
    pub fn connect(&mut self) -> Result<(), Cause> {
        if let Some(Departure::At(axes)) = self.departure {
            let mut back = departure::connection(&self.arm, axes.into(), self.axes_on_path().into(), self.tool)?;
            back.executor = self.executor;
            back.limit_tool_speed(self.tool_speed);
            self.departure = Some(Departure::Connecting(Box::new(back)));
        }
        Ok(())
    }

    /// Cause for which the recorded path cannot be followed to its end. [`Motion::record`] rejects further moves with
    /// this cause.
    #[must_use]
    pub fn fault(&self) -> Option<&Cause> {
        self.fault.as_ref().map(|fault| &fault.cause)
    }

    /// Fault of the recorded path: [`Motion::fault`] with the affected move.
    #[must_use]
    pub const fn path_fault(&self) -> Option<&PathFault> {
        self.fault.as_ref()
    }

    /// Fault of the recorded path if the arm has stopped at it; `None` otherwise.
    #[must_use]
    pub fn stuck(&self) -> Option<&PathFault> {
        self.fault.as_ref().filter(|_| self.timeline.is_at_end() || self.has_altered_fault())
    }

    /// Joint position at the end of the last recorded move, where the next move begins.
    #[must_use]
    pub fn destination(&self) -> Joints {
        self.tail().destination().into()
    }

    /// Sets the arm model and the joint position, and removes all recorded moves.
    pub fn place(&mut self, arm: Arc<Arm>, joints: Joints) {
        let Self { executor, mode, revision, done_id, is_stopped, is_braked, tool_speed, .. } = *self;
        let mut queue = std::mem::take(&mut self.queue);
        queue.forget();
        let new = Self::new(arm, joints);
        *self = Self { executor, mode, queue, revision, done_id, is_stopped, is_braked, tool_speed, ..new };
    }

    /// Sets the monitor speed.
    pub fn set_monitor_speed(&mut self, speed: Percent) {
        let at_rest = self.timeline.rate() == 0.0;
        self.executor.set_monitor_speed(speed, at_rest);
        if let Some(motion) = self.moving_away() {
            motion.set_monitor_speed(speed);
        }
    }

    /// Advances the motion by a duration, usually one cycle of 4 ms.
    pub fn advance(&mut self, duration: Seconds) -> Sample {
        if let Some(front) = self.timeline.spans.front() {
            self.tool = front.span.tool;
        }
        let before = Model(&self.arm).flange(&self.commanded) * self.tool;
        let moved = match self.moving_away() {
            Some(motion) => motion.move_on(duration),
            None => self.departure.is_none() && self.move_on(duration),
        };
        let phase = if moved { self.phase() } else { MotionPhase::Waiting };
        self.limit(phase);
        self.settle_departure();
        self.commanded = self.axes();
        let pose = Model(&self.arm).flange(&self.commanded) * self.tool;
        let way = (pose.translation.vector - before.translation.vector).norm();
        self.speed = if duration.0 > 0.0 { way / duration.0 } else { self.speed };
        Sample { joints: self.joints(), pose, speed: MillimetresPerSecond(self.speed), id: self.move_id(), phase }
    }

    /// Updates the departure when the arm has come to rest away from its path or has returned to the path.
    fn settle_departure(&mut self) {
        if self.departure.is_none() {
            return;
        }
        let target = self.axes_on_path();
        match &self.departure {
            Some(Departure::Braking(motion)) if !motion.is_going() => {
                self.departure = Departure::at(motion.axes_on_path(), &target);
            }
            Some(Departure::Connecting(motion)) if motion.is_empty() => self.departure = None,
            Some(Departure::At(axes)) => {
                let connection = Connection::between(&Model(&self.arm), axes, &target, &self.tool);
                let is_held = self.is_stopped || self.is_braked;
                if !connection.is_needed() && !is_held && !self.timeline.is_at_end() {
                    self.departure = None;
                }
            }
            _ => {}
        }
    }

    /// Moves the arm on its path or with a deviation. Returns whether the arm has moved.
    fn move_on(&mut self, duration: Seconds) -> bool {
        // A deviation moves the arm even if the nominal motion rests.
        self.acting = ActingLimit::Known(SpeedLimit::Alter);
        let moved = !self.is_at_halt() && !self.has_altered_fault() && self.follow(duration);
        self.deviate(duration) || moved
    }

    /// Follows the timeline and updates the stages of the moves. Returns whether the arm has moved.
    fn follow(&mut self, duration: Seconds) -> bool {
        self.release_at_rest();
        if self.timeline.waits_at_gate() {
            return false;
        }
        if let Some(moved) = self.glide(duration) {
            return moved;
        }
        let Self { executor, timeline, queue, fault, .. } = self;
        let present = timeline.spans.front().filter(|front| !front.is_forgotten).map(|front| front.span.part);
        let Advance { moved, end } = executor.advance(timeline, duration, |done, next, at| {
            if done.part != next.part {
                queue.begin(&done.part, Seconds(0.0));
                if done.ends_its_move() {
                    queue.end(&done.part, at);
                }
                queue.begin(&next.part, at);
            }
        });
        if let Some(state) = timeline.state(executor.pace()).filter(|_| moved) {
            self.acting = ActingLimit::OnPath(state);
        }
        if let Some(present) = present.filter(|_| moved) {
            queue.begin(&present, Seconds(0.0));
        }
        if let Some(front) =
            timeline.spans.front().filter(|front| timeline.waits_at_gate() && front.span.ends_its_move())
        {
            queue.end(&front.span.part, end);
        }
        if timeline.is_at_end() && fault.is_none() {
            if self.alteration.is_none() {
                self.record_deferred();
            }
            if self.is_empty() {
                self.queue.finish_all(end);
            }
        }
        moved
    }

    /// Follows a compliant move. Returns whether the arm has moved; `None` if the current move is not compliant.
    fn glide(&mut self, duration: Seconds) -> Option<bool> {
        let (timed, command) = self.timeline.compliant()?;
        let (span, reduction) = (Arc::clone(&timed.span), timed.reduction.clone());
        let pace = self.executor.stretched(duration.0) / duration.0;
        let forces = Forces { command, external: self.external_force, pace, reduction: reduction.as_ref() };
        let mut glide = self.timeline.cursor.glide.unwrap_or_else(|| Glide::at_start(&span));
        let moved = duration.0 > 0.0 && glide.advance(&Model(&self.arm), &span, &forces, duration);
        let [_, end] = span.range();
        self.queue.begin(&span.part, Seconds(0.0));
        self.timeline.cursor.glide = Some(glide);
        if glide.p >= end {
            self.timeline.pass_compliant();
            self.queue.end(&span.part, duration);
        }
        Some(moved)
    }

    /// Sets the force that acts on the arm until the next call. Compliant moves yield to the force.
    pub fn set_external_force(&mut self, force: ExternalForce) {
        self.external_force = force;
    }

    /// Whether the arm yields to forces: a compliant move is being executed, and the arm is not held (`isCompliant`).
    #[must_use]
    pub fn is_compliant(&self) -> bool {
        let is_held = self.is_stopped || self.is_braked || self.departure.is_some();
        !is_held && self.timeline.cursor.glide.is_some()
    }

    /// Recorded moves that are not done.
    pub fn moves(&self) -> impl ExactSizeIterator<Item = &QueuedMove> {
        self.queue.moves()
    }

    /// Returns and clears the move events since the last call.
    pub fn take_events(&mut self) -> Vec<MoveEvent> {
        self.queue.take_events()
    }

    /// Commanded joint position.
    #[must_use]
    pub fn joints(&self) -> Joints {
        self.commanded.into()
    }

    /// Result of `getMoveId` (section (b) of the motion model).
    #[must_use]
    pub fn move_id(&self) -> f64 {
        match (self.timeline.spans.front(), self.timeline.p()) {
            (Some(front), _) if front.is_forgotten && !self.timeline.is_at_end() => 0.0,
            (Some(front), Some(p)) if !self.is_empty() => front.span.part.id_at(p),
            _ => self.done_id,
        }
    }

    /// Sets the result of `getMoveId` while no move is pending.
    pub const fn set_done_id(&mut self, id: f64) {
        self.done_id = id;
    }

    /// Time until the end of the determined path, at full monitor speed.
    #[must_use]
    pub fn time_left(&self) -> Seconds {
        Seconds(self.timeline.seconds_left())
    }

    /// Whether a cycle would move the arm if power is on and the monitor speed is above 0.
    #[must_use]
    pub fn can_go_on(&self) -> bool {
        match &self.departure {
            None if self.has_altered_fault() => false,
            None if self.alteration.as_ref().is_some_and(Alteration::is_pending) => true,
            None => !(self.has_arrived() || self.is_stopped && self.timeline.rate() == 0.0),
            Some(Departure::At(_)) => false,
            Some(Departure::Braking(motion) | Departure::Connecting(motion)) => motion.can_go_on(),
        }
    }

    /// Whether the arm executes a recorded move or a connection move.
    #[must_use]
    pub fn is_moving(&self) -> bool {
        self.timeline.rate() > 0.0
            || matches!(&self.departure, Some(Departure::Braking(motion) | Departure::Connecting(motion)) if motion.is_going())
    }

    /// Whether a cycle would move the arm.
    fn is_going(&self) -> bool {
        match &self.departure {
            None => !self.has_arrived() && !self.is_at_halt() && !self.has_altered_fault(),
            Some(Departure::At(_)) => false,
            Some(Departure::Braking(motion) | Departure::Connecting(motion)) => motion.is_going(),
        }
    }

    /// Whether a stop has brought the arm to rest.
    fn is_at_halt(&self) -> bool {
        (self.is_stopped || self.is_braked) && self.timeline.rate() == 0.0
    }

    pub(crate) fn axes(&self) -> Axes {
        self.departure.as_ref().map_or_else(|| self.axes_on_path(), Departure::axes)
    }

    fn axes_on_path(&self) -> Axes {
        self.alteration.as_ref().map_or_else(|| self.axes_without_deviation(), Alteration::axes)
    }

    fn axes_without_deviation(&self) -> Axes {
        match (self.timeline.spans.front(), self.timeline.p()) {
            (Some(front), Some(p)) => front.span.axes(&Model(&self.arm), p),
            _ => self.rest,
        }
    }

    fn phase(&self) -> MotionPhase {
        match self.timeline.spans.front() {
            _ if matches!(self.departure, Some(Departure::Connecting(_))) => MotionPhase::Connection,
            _ if self.departure.is_some() => MotionPhase::Stopping,
            _ if self.executor.is_halting() => MotionPhase::Stopping,
            Some(front) if front.is_forgotten => MotionPhase::Stopping,
            Some(front) if matches!(front.span.manner, Manner::Compliant(_)) => MotionPhase::Compliant,
            _ if self.alteration.is_some() => MotionPhase::Alter,
            Some(front) if front.span.is_blend() => MotionPhase::Blend,
            _ => MotionPhase::Nominal,
        }
    }

    /// Appends the spans that the move with this serial number has determined.
    fn append(&mut self, determined: Determined, serial: u64) {
        for (span, from_rest) in determined.spans {
            let timed = self.timed(span, from_rest);
            self.timeline.append(timed, self.mode);
            self.revision += 1;
        }
        let is_blend = determined.has_blend_fault;
        let serial = determined.blended.filter(|_| is_blend).unwrap_or(serial);
        let fault = determined.fault.map(|cause| PathFault { serial, is_blend, cause });
        self.fault = self.fault.take().or(fault);
    }

    fn check(&self) -> Result<(), Cause> {
        self.fault.as_ref().map_or(Ok(()), |fault| Err(fault.cause.clone()))
    }
}

#[cfg(test)]
mod tests;
