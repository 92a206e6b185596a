//! The arm of the controller: its model, its recorded moves and its motion (9.2.3, 10.6, 11). `devices/motion.rs` is its port.

mod request;

use std::sync::Arc;

use val3_geometry::IsometryMatrix3;
use val3_kinematics::{Arm, DEFAULT_SCARA, DEFAULT_SIX_AXIS, Dh, DhError, Violation};
use val3_lang::ports::{MoveRequest, Time};
use val3_motion::{Cause, Motion, Percent, Sample, Seconds};
use val3_vm::CYCLE;

use crate::event::seconds;

/// The arm stands still this long before it counts as settled (10.6).
const SETTLING: Time = 50_000_000;

/// The arm.
#[derive(Debug, Clone)]
pub struct RobotArm {
    model: Arc<Arm>,
    /// The cell, the settings or a user have chosen the model.
    is_chosen: bool,
    motion: Motion,
    next_id: f64,
    connects_by_itself: bool,
    /// The state after the last cycle in which the arm was looked at.
    sample: Sample,
    /// For how long the arm has been at rest.
    resting: Time,
}

/// Why a move is not recorded.
#[derive(Debug, Clone, PartialEq)]
pub enum MoveError {
    /// A move recorded before cannot be done.
    Earlier(Cause),
    /// This move cannot be done.
    Refused(Cause),
}

impl Default for RobotArm {
    fn default() -> Self {
        Self::of_kind(false)
    }
}

impl RobotArm {
    /// The default arm of a kind, at joint position zero.
    #[must_use]
    pub fn of_kind(is_scara: bool) -> Self {
        let name = if is_scara { DEFAULT_SCARA } else { DEFAULT_SIX_AXIS };
        #[allow(clippy::expect_used, reason = "the tests of val3-kinematics load every shipped arm")]
        let model = Arm::by_name(name).expect("a shipped arm");
        Self { is_chosen: false, ..Self::new(model) }
    }

    /// An arm of this model, at joint position zero.
    #[must_use]
    pub fn new(model: Arm) -> Self {
        let model = Arc::new(model);
        let mut motion = Motion::new(Arc::clone(&model), [0.0; 6]);
        let sample = motion.advance(Seconds(0.0));
        Self { model, is_chosen: true, motion, next_id: 0.0, connects_by_itself: false, sample, resting: SETTLING }
    }

    /// Its model.
    #[must_use]
    pub fn model(&self) -> &Arm {
        &self.model
    }

    /// Whether somebody has chosen the model; otherwise it is the default of its kind.
    #[must_use]
    pub const fn is_chosen(&self) -> bool {
        self.is_chosen
    }

    /// Narrows the software limits to those of `minArmJointPos` and `maxArmJointPos`.
    ///
    /// # Errors
    /// No position of an axis would be left.
    pub fn narrow(&mut self, lowest: &[f64], highest: &[f64]) -> Result<(), Violation> {
        let model = Arm::clone(&self.model).with_limits(lowest, highest)?;
        self.replace(model);
        Ok(())
    }

    /// `setDH`.
    ///
    /// # Errors
    /// The parameters differ too much from those of the arm type.
    pub fn set_dh(&mut self, dh: &Dh) -> Result<(), DhError> {
        let mut model = Arm::clone(&self.model);
        model.set_dh(dh)?;
        self.replace(model);
        Ok(())
    }

    fn replace(&mut self, model: Arm) {
        self.model = Arc::new(model);
        self.put(self.motion.joints());
    }

    /// Puts the arm at a joint position. Every recorded move is forgotten.
    pub fn put(&mut self, joint: [f64; 6]) {
        self.motion.place(Arc::clone(&self.model), joint);
        self.sample = self.motion.advance(Seconds(0.0));
    }

    /// `resetTurn`: the last axis gets the position nearest to its reference.
    pub fn reset_turn(&mut self, reference: &[f64; 6]) -> [f64; 6] {
        let mut joint = self.motion.joints();
        let shift = self.model.turn_shift(&joint, reference);
        if let Some(last) = self.model.axes().checked_sub(1).and_then(|last| joint.get_mut(last)) {
            *last += shift;
        }
        self.put(joint);
        joint
    }

    /// Where the controller wants each axis.
    #[must_use]
    pub fn joint(&self) -> [f64; 6] {
        self.motion.joints()
    }

    /// Where the encoders find each axis.
    #[must_use]
    pub fn measured_joint(&self) -> [f64; 6] {
        self.motion.joints()
    }

    /// The state after the last cycle.
    #[must_use]
    pub const fn sample(&self) -> &Sample {
        &self.sample
    }

    /// The speed of a tool centre point over the last cycle, in mm/s.
    #[must_use]
    pub fn speed(&self, _tool: &IsometryMatrix3<f64>) -> f64 {
        self.sample.speed.0
    }

    /// Records a move and gives its id; `None` while no more moves can be recorded.
    ///
    /// # Errors
    /// It, or a move recorded before, cannot be done.
    pub fn record(&mut self, request: &MoveRequest) -> Result<Option<f64>, MoveError> {
        if let Some(cause) = self.motion.fault() {
            return Err(MoveError::Earlier(cause.clone()));
        }
        let id = self.next_id;
        let request = request::to_move(&self.model, request, &self.motion.destination(), id)
            .map_err(|cause| MoveError::Refused(cause.into()))?;
        self.motion.record(&request).map_err(MoveError::Refused)?;
        self.next_id = id + 1.0;
        Ok(Some(id))
    }

    /// Lets the last recorded move end without a blend. Whether every recorded move is done.
    ///
    /// # Errors
    /// A recorded move cannot be done.
    pub fn arrive(&mut self) -> Result<bool, MoveError> {
        self.motion.close().map_err(MoveError::Earlier)?;
        Ok(self.motion.is_empty())
    }

    /// Every recorded move is done.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.motion.is_empty()
    }

    /// No motion is commanded.
    #[must_use]
    pub fn is_at_rest(&self) -> bool {
        self.resting > 0
    }

    /// It stands still.
    #[must_use]
    pub fn is_settled(&self) -> bool {
        self.resting >= SETTLING
    }

    /// `stopMove`.
    pub fn stop(&mut self) {
        self.motion.stop();
    }

    /// `restartMove`.
    pub fn restart(&mut self) {
        self.motion.restart();
    }

    /// `resetMotion`: the next move starts at `start`, or wherever the arm is.
    pub fn reset(&mut self, _start: Option<[f64; 6]>) {
        self.motion.reset();
        self.next_id = 0.0;
    }

    /// `getMoveId`.
    #[must_use]
    pub fn move_id(&self) -> f64 {
        self.motion.move_id()
    }

    /// Sets the id of the next move.
    pub fn set_next_move(&mut self, id: f64) {
        self.next_id = id;
    }

    /// `autoConnectMove`: the present choice.
    #[must_use]
    pub const fn connects_by_itself(&self) -> bool {
        self.connects_by_itself
    }

    /// `autoConnectMove`: makes a choice.
    pub fn connect_by_itself(&mut self, active: bool) {
        self.connects_by_itself = active;
    }

    /// Moves on by a cycle; only where the arm `may_move`. `speed` is the monitor speed.
    pub fn advance(&mut self, may_move: bool, speed: Percent) {
        if !may_move {
            self.resting = self.resting.saturating_add(CYCLE);
            return;
        }
        self.motion.set_monitor_speed(speed);
        let before = self.sample.joints;
        self.sample = self.motion.advance(Seconds(seconds(CYCLE)));
        self.resting = if self.sample.joints == before { self.resting.saturating_add(CYCLE) } else { 0 };
    }

    /// A cycle would change its state, where it `may_move` or not.
    #[must_use]
    pub fn is_busy(&self, may_move: bool) -> bool {
        !self.is_settled() || may_move && self.motion.is_going()
    }
}
