//! Stop, emergency brake, restart and release of the arm.

use std::sync::Arc;

use super::Motion;
use crate::emergency;
use crate::model::Model;
use crate::span::Span;

impl Motion {
    /// Brakes on the path and holds the arm until a restart (`stopMove`).
    pub fn stop(&mut self) {
        match self.moving_away() {
            Some(motion) => motion.stop(),
            None => self.halt_as_planned(),
        }
        if !std::mem::replace(&mut self.is_stopped, true) {
            self.stop_alteration(false);
        }
    }

    /// Whether the motion is between a stop and a restart.
    #[must_use]
    pub const fn is_stopped(&self) -> bool {
        self.is_stopped
    }

    /// Brakes on the path with the arm's greatest deceleration and holds the arm until [`Motion::resume`] (power cut,
    /// emergency stop).
    pub fn brake(&mut self) {
        if !std::mem::replace(&mut self.is_braked, true) {
            self.stop_alteration(true);
            match self.moving_away() {
                Some(motion) => motion.brake(),
                None => {
                    let arm = Arc::clone(&self.arm);
                    self.halt(|span, p, x| emergency::braking(&Model(&arm), span, p, x));
                }
            }
        }
    }

    /// Brakes within the limits of the moves, unless the arm is already braking.
    pub(super) fn halt_as_planned(&mut self) {
        // A path that was recorded while the arm is held at rest has no halt yet.
        if !self.executor.is_halting() || !self.timeline.has_halt {
            self.halt(|span, p, x| span.bounds_at(p, None).map_or(f64::NEG_INFINITY, |bounds| bounds.lowest(x)));
        }
    }

    fn halt(&mut self, braking: impl Fn(&Span, f64, f64) -> f64) {
        if let Some(glide) = &mut self.timeline.cursor.glide {
            glide.rate = 0.0;
        }
        if !self.timeline.is_at_end() {
            self.timeline.halt(self.executor.halt(), braking);
        }
    }

    /// Continues after [`Motion::brake`], unless the arm is stopped.
    pub fn resume(&mut self) {
        if std::mem::take(&mut self.is_braked) {
            self.release();
        }
    }

    /// Continues after a stop (`restartMove`). Has no effect without a stop.
    pub fn restart(&mut self) {
        if std::mem::take(&mut self.is_stopped) {
            self.release();
        }
    }

    /// Releases the arm as far as neither a stop nor a brake holds it.
    fn release(&mut self) {
        let (is_stopped, is_braked) = (self.is_stopped, self.is_braked);
        if let Some(alteration) = self.alteration.as_mut().filter(|_| !is_stopped && !is_braked) {
            alteration.locks_in = None;
        }
        if let Some(motion) = self.moving_away() {
            (motion.is_stopped, motion.is_braked) = (is_stopped, is_braked);
            motion.release();
        }
        self.release_at_rest();
    }

    /// Ends a halt without a remaining hold when the arm has come to rest.
    pub(super) fn release_at_rest(&mut self) {
        let is_held = self.is_stopped || self.is_braked;
        if self.executor.is_halting() && !is_held && self.timeline.rate() == 0.0 {
            self.timeline.release();
            self.executor.release();
        }
    }
}
