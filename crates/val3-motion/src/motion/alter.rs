//! Alter mode: its requests, and the moves that wait for its end.

use std::collections::VecDeque;

use val3_geometry::IsometryMatrix3;
use val3_moves::{AlterReference, Manner, Seconds};

use super::{Determined, Motion};
use crate::alteration::{AlterStatus, Alteration};
use crate::deferred::{Deferred, DeferredRequest};
use crate::fault::{Cause, PathFault};
use crate::model::{Axes, Model};
use crate::path::PathEnd;
use crate::request::{Move, SpeedLimits};
use crate::timeline::Timeline;

/// Points per span at which a deviation is followed to the end of the path.
const PLACES: u32 = 16;

/// Alter mode.
impl Motion {
    /// Enters the alter mode on the current alterable path (`alterBegin`). `limits` apply to the deviated path.
    pub fn alter_begin(&mut self, reference: AlterReference, limits: SpeedLimits) -> AlterStatus {
        match &self.alteration {
            _ if self.fault.is_some() => AlterStatus::Fault,
            Some(alteration) if !alteration.is_ended => AlterStatus::Ignored,
            None if self.is_on_alterable_path() => {
                let axes = self.axes_on_path();
                self.alteration = Some(Alteration::new(&Model(&self.arm), reference, limits, axes));
                AlterStatus::Done
            }
            _ => AlterStatus::Waiting,
        }
    }

    /// Sets the deviation, effective from the next cycle on (`alter`).
    pub fn alter(&mut self, transformation: IsometryMatrix3<f64>) -> AlterStatus {
        match &mut self.alteration {
            _ if self.fault.is_some() => AlterStatus::Fault,
            Some(alteration) if !alteration.is_ended => {
                if alteration.locks_in == Some(0.0) {
                    return AlterStatus::Waiting;
                }
                alteration.set(transformation);
                AlterStatus::Done
            }
            _ => AlterStatus::Ignored,
        }
    }

    /// Ends the alter mode (`alterEnd`). The deviation stays in effect to the end of the alterable path.
    pub fn alter_end(&mut self) -> AlterStatus {
        match &mut self.alteration {
            _ if self.fault.is_some() => AlterStatus::Fault,
            Some(alteration) if !alteration.is_ended => {
                alteration.is_ended = true;
                self.record_deferred();
                self.settle_alteration();
                AlterStatus::Done
            }
            _ => AlterStatus::Ignored,
        }
    }

    /// Time until a stop locks the deviation (`alterStopTime`): negative without a stop, 0 outside of the alter mode.
    #[must_use]
    pub fn alter_stop_time(&self) -> Seconds {
        let alteration = self.alteration.as_ref().filter(|alteration| !alteration.is_ended && self.fault.is_none());
        Seconds(alteration.map_or(0.0, |alteration| alteration.locks_in.unwrap_or(-1.0)))
    }

    fn is_on_alterable_path(&self) -> bool {
        let front = self.timeline.spans.front().filter(|front| !front.is_forgotten);
        let is_alterable = front.is_some_and(|front| front.span.manner == Manner::Alterable);
        let has_started = front.zip(self.timeline.p()).is_some_and(|(front, p)| p > front.span.range()[0]);
        is_alterable && has_started && !self.is_nominal_done()
    }

    /// Whether an impossible deviation holds the arm until a reset.
    pub(super) fn has_altered_fault(&self) -> bool {
        self.alteration.as_ref().is_some_and(|alteration| alteration.has_failed)
    }

    /// Starts locking the deviation at the beginning of a stop.
    pub(super) fn stop_alteration(&mut self, is_emergency: bool) {
        if let Some(alteration) = &mut self.alteration {
            alteration.stop(is_emergency);
        }
    }

    /// Executes one cycle of the deviation. Returns whether the arm has moved.
    pub(super) fn deviate(&mut self, duration: Seconds) -> bool {
        let front = self.timeline.spans.front();
        if front.is_some_and(|front| front.span.manner != Manner::Alterable) {
            self.alteration = None;
        }
        if self.alteration.is_none() || self.has_altered_fault() {
            return false;
        }
        let (nominal, serial) = (self.axes_without_deviation(), self.current().unwrap_or_default());
        let Some(alteration) = &mut self.alteration else { return false };
        let before = alteration.axes();
        if let Err(cause) = alteration.advance(&Model(&self.arm), &nominal, &self.tool, duration) {
            alteration.has_failed = true;
            self.fault = Some(PathFault { serial, is_blend: false, cause });
        }
        let moved = alteration.axes() != before;
        self.settle_alteration();
        moved
    }

    /// Discards the recorded moves. The deviation stays until the arm has braked.
    pub(super) fn reset_alteration(&mut self) {
        self.deferred = None;
        let Some(alteration) = self.alteration.as_mut() else { return };
        (alteration.is_ended, alteration.locks_in) = (true, None);
        let axes = alteration.axes();
        // After a failure the arm is already at rest. If the braking path cannot be followed with the deviation, the
        // arm stops immediately.
        let end = if alteration.has_failed { None } else { self.deviated_end().ok() };
        if end.is_none() {
            (self.timeline, self.rest) = (Timeline::default(), axes);
        }
        self.path = PathEnd::starting_at(end.unwrap_or(axes));
        if self.timeline.spans.is_empty() {
            self.alteration = None;
        }
    }

    /// Starts the next move at the end of a completed deviation.
    fn settle_alteration(&mut self) {
        let ended = self.alteration.as_ref().filter(|alteration| alteration.is_ended && !alteration.has_failed);
        if let Some(axes) = ended.map(Alteration::axes).filter(|_| self.is_nominal_done()) {
            let is_forgotten = self.timeline.spans.front().is_some_and(|front| front.is_forgotten);
            (self.rest, self.timeline, self.alteration) = (axes, Timeline::default(), None);
            if !is_forgotten {
                self.path = PathEnd::starting_at(axes);
            }
        }
    }
}

/// Moves after an alterable path.
impl Motion {
    /// End of the recorded path, deferred moves included.
    pub(super) fn tail(&self) -> &PathEnd {
        self.deferred.as_ref().map_or(&self.path, |deferred| &deferred.nominal)
    }

    /// Whether a move has to wait because the end of the preceding alterable path is unknown.
    pub(super) fn must_wait(&self, request: &Move) -> bool {
        let is_ended = self.alteration.as_ref().is_some_and(|alteration| alteration.is_ended);
        self.deferred.is_some() || request.manner != Manner::Alterable && self.ends_alterable() && !is_ended
    }

    /// Stores a move until the preceding alterable path has ended.
    ///
    /// # Errors
    /// Returns the cause if the move is impossible from the end of the nominal path, without a deviation.
    pub(super) fn defer(&mut self, request: &Move, serial: u64) -> Result<(), Cause> {
        let mut nominal = self.tail().clone();
        nominal.record(&Model(&self.arm), request, serial)?;
        let mut requests = self.deferred.take().map_or_else(VecDeque::new, |deferred| deferred.requests);
        requests.push_back(DeferredRequest::Move(serial, Box::new(request.clone())));
        self.deferred = Some(Deferred { requests, nominal });
        Ok(())
    }

    /// Records the deferred moves after the end of the alterable path.
    pub(super) fn record_deferred(&mut self) {
        let Some(deferred) = self.deferred.take() else { return };
        for request in deferred.requests {
            if self.fault.is_some() {
                return;
            }
            match request {
                DeferredRequest::Move(serial, request) => match self.determine(&request, serial) {
                    Ok(determined) => {
                        self.queue.lay_out(serial, determined.reach, determined.leave);
                        self.append(determined, serial);
                    }
                    Err(cause) => self.fault = Some(PathFault { serial, is_blend: false, cause }),
                },
                DeferredRequest::Close => self.close_path(),
            }
        }
    }

    /// Determines the path of a move, which begins at the deviated end of a preceding alterable path.
    pub(super) fn determine(&mut self, request: &Move, serial: u64) -> Result<Determined, Cause> {
        let is_rigid_after_alterable = request.manner != Manner::Alterable && self.ends_alterable();
        if is_rigid_after_alterable && self.alteration.as_ref().is_some_and(|alteration| alteration.is_ended) {
            let (model, near) = (Model(&self.arm), self.deviated_end()?);
            if let Some(alteration) = &self.alteration {
                let rate = self.path.deviate(&model, alteration, near)?;
                if let (Some(last), Some(_)) = (self.timeline.spans.back_mut(), rate) {
                    last.exit_rate = rate;
                }
            }
        }
        self.path.record(&Model(&self.arm), request, serial)
    }

    /// End of the path with the current deviation.
    fn deviated_end(&self) -> Result<Axes, Cause> {
        let model = Model(&self.arm);
        let Some(alteration) = &self.alteration else { return Ok(self.path.destination()) };
        let mut near = alteration.axes();
        let first = self.timeline.p();
        for (index, timed) in self.timeline.spans.iter().enumerate() {
            let [start, _] = timed.span.range();
            let from = first.filter(|_| index == 0).unwrap_or(start);
            let to = timed.points.last().map_or(start, |point| point.p);
            for place in 1..=PLACES {
                let p = from + (to - from) * f64::from(place) / f64::from(PLACES);
                near = alteration.applied_to(&model, &timed.span.axes(&model, p), &near)?;
            }
        }
        Ok(near)
    }

    /// Whether the path ends with an alterable part whose deviation can still change.
    fn ends_alterable(&self) -> bool {
        let last = self.timeline.spans.back().filter(|last| !last.is_forgotten);
        let is_over = self.alteration.is_none() && self.timeline.is_at_end();
        last.is_some_and(|last| last.span.manner == Manner::Alterable) && !is_over
    }

    /// Whether the arm is at the end of the path, ignoring deviations and deferred moves.
    pub(super) fn is_nominal_done(&self) -> bool {
        self.timeline.is_at_end() && !self.path.is_open()
    }
}
