//! The motion of one arm: records moves, plans them, and executes them.

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

/// A queue of moves with the state of their execution: plain data, so that a copy is a snapshot.
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
    /// `getMoveId` once everything recorded is done.
    done_id: f64,
    tool: IsometryMatrix3<f64>,
    /// State of an arm that is away from the path.
    departure: Option<Departure>,
    /// Speed of the tool centre point over the last cycle, in mm/s.
    speed: f64,
    /// Whether the motion is between `stopMove` and `restartMove`.
    is_stopped: bool,
    /// Whether the motion is between an emergency stop and the return of power.
    is_braked: bool,
    external_force: ExternalForce,
    /// Greatest speed of the tool centre point and of the flange; `None` without a limit.
    tool_speed: Option<MillimetresPerSecond>,
    /// The deviation from an alterable path.
    alteration: Option<Alteration>,
    deferred: Option<Deferred>,
    /// Commanded state at the end of the last cycle.
    commanded: Axes,
    /// See [`Motion::speed_limit`].
    acting: ActingLimit,
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
    /// Kind of motion.
    pub phase: MotionPhase,
}

impl Motion {
    /// An arm that rests at these joints.
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
    /// The destination cannot be reached, the arm cannot follow the line or circle to it, or the path recorded before
    /// cannot be followed. Nothing is recorded then.
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

    /// The move with a joint position instead of a point as the destination of a joint move. A deferred move keeps this
    /// joint position, wherever it starts later.
    fn with_joints<'a>(&self, request: &'a Move) -> Result<Cow<'a, Move>, Cause> {
        let MovePath::JointToPoint(target) = &request.path else { return Ok(Cow::Borrowed(request)) };
        let joints = self.tail().joints_at(&Model(&self.arm), target, &request.tool)?;
        Ok(Cow::Owned(Move { path: MovePath::Joint(joints), ..request.clone() }))
    }

    /// The path of a move. Only a fault of the blend before it is left in the result.
    ///
    /// # Errors
    /// The destination cannot be reached, or the arm cannot follow the line or circle to it (manual 10.6). The path is
    /// unchanged then.
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

    /// Lets the last recorded move end at its destination (`waitEndMove`).
    ///
    /// # Errors
    /// The recorded path cannot be followed.
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

    /// Whether everything recorded is done (`isEmpty`).
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.is_nominal_done() && self.deferred.is_none() && self.fault.is_none()
    }

    /// The motion of an arm that is not on its path.
    fn moving_away(&mut self) -> Option<&mut Self> {
        self.departure.as_mut().and_then(Departure::motion)
    }

    /// Brakes on the path and removes all recorded moves (`resetMotion`).
    /// The next move starts where the arm comes to rest.
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

    /// Brakes on the path, and forgets it from there on.
    fn cut(&mut self) {
        if self.timeline.compliant().is_some() {
            self.rest = self.axes_on_path();
            self.timeline = Timeline::default();
        }
        self.halt_as_planned();
        self.timeline.cut();
    }

    /// As [`Motion::reset`], but the next move starts at `start`, to which a connection move has to lead first.
    pub fn reset_to(&mut self, start: Joints) {
        self.reset();
        let mut left = Self { timeline: std::mem::take(&mut self.timeline), ..self.clone() };
        left.departure = None;
        self.alteration = None;
        (self.rest, self.path) = (start.into(), PathEnd::starting_at(start.into()));
        self.departure = Some(Departure::Braking(Box::new(left)));
        self.settle_departure();
    }

    /// Moves the arm away from its path, as an operator does by hand. Where no move is left, the next one begins there.
    /// Nothing happens while it moves on its path.
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

    /// Connection of an arm that rests away from its path.
    #[must_use]
    pub fn connection(&self) -> Option<Connection> {
        let Some(Departure::At(axes)) = &self.departure else { return None };
        let connection = Connection::between(&Model(&self.arm), axes, &self.axes_on_path(), &self.tool);
        Some(connection).filter(Connection::is_needed)
    }

    /// Starts the way back to the path, where the arm rests away from it.
    ///
    /// # Errors
    /// The start of the path is outside the limits of an axis.
    pub fn connect(&mut self) -> Result<(), Cause> {
        if let Some(Departure::At(axes)) = self.departure {
            let mut back = departure::connection(&self.arm, axes.into(), self.axes_on_path().into(), self.tool)?;
            back.executor = self.executor;
            back.limit_tool_speed(self.tool_speed);
            self.departure = Some(Departure::Connecting(Box::new(back)));
        }
        Ok(())
    }

    /// Reason why the recorded path cannot be followed to its end; the next move is rejected with it.
    #[must_use]
    pub fn fault(&self) -> Option<&Cause> {
        self.fault.as_ref().map(|fault| &fault.cause)
    }

    /// [`Motion::fault`] with the move whose path is impossible.
    #[must_use]
    pub const fn path_fault(&self) -> Option<&PathFault> {
        self.fault.as_ref()
    }

    /// The fault of the recorded path, once the arm rests before the part that it cannot follow.
    #[must_use]
    pub fn stuck(&self) -> Option<&PathFault> {
        self.fault.as_ref().filter(|_| self.timeline.is_at_end() || self.has_altered_fault())
    }

    /// Joint position at which the last recorded move ends and the next move begins.
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

    /// Moves on by a duration, one cycle of 4 ms as a rule.
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

    /// The arm has come to rest away from its path, or is back on it.
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

    /// Moves on its path or with a deviation from it. Returns whether the arm has moved.
    fn move_on(&mut self, duration: Seconds) -> bool {
        // A deviation can move an arm that rests on its path.
        self.acting = ActingLimit::Known(SpeedLimit::Alter);
        let moved = !self.is_at_halt() && !self.has_altered_fault() && self.follow(duration);
        self.deviate(duration) || moved
    }

    /// Follows the timeline, and keeps account of the moves. Returns whether the arm has moved.
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

    /// Follows a compliant move; `None` if no compliant move is executed.
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

    /// A force that acts on the arm until the next call. Compliant moves yield to it.
    pub fn set_external_force(&mut self, force: ExternalForce) {
        self.external_force = force;
    }

    /// Whether the arm yields to forces: a compliant move is executed, and nothing holds it (`isCompliant`).
    #[must_use]
    pub fn is_compliant(&self) -> bool {
        let is_held = self.is_stopped || self.is_braked || self.departure.is_some();
        !is_held && self.timeline.cursor.glide.is_some()
    }

    /// The recorded moves that are not done.
    pub fn moves(&self) -> impl ExactSizeIterator<Item = &QueuedMove> {
        self.queue.moves()
    }

    /// Events of moves since the last call.
    pub fn take_events(&mut self) -> Vec<MoveEvent> {
        self.queue.take_events()
    }

    /// Commanded joint position.
    #[must_use]
    pub fn joints(&self) -> Joints {
        self.commanded.into()
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

    /// Whether a cycle would move the arm once it has power and a monitor speed above 0.
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

    /// Whether a recorded move or a connection move is being executed.
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

    /// Appends the spans that the move with this number has determined.
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
