//! The arm of the controller: its model, its recorded moves and its motion (9.2.3, 10.6, 11). `devices/motion.rs` is its
//! port.

mod clients;
mod drive;
mod excess;
mod feedback;
mod latch;
mod request;
mod stepping;

use std::collections::BTreeMap;
use std::sync::Arc;

use val3_geometry::IsometryMatrix3;
use val3_kinematics::{Arm, DEFAULT_SCARA, DEFAULT_SIX_AXIS, Dh, DhError, Joints, Violation};
use val3_lang::ports::{CodePlace, MoveRequest, SECOND, Time};
use val3_lang::values::MdescValue;
use val3_motion::{
    AlterReference, Cause, Degrees, ExternalForce, Jog, Millimetres, Motion, MotionPhase, MoveEvent, PathFault,
    Percent, QueuedMove, Sample, Seconds, SpeedLimit,
};
use val3_vm::CYCLE;

use crate::event::seconds;

pub use clients::{ClientCommand, ClientMoveError};
pub use drive::{ArmHold, Drive};
pub use latch::Latch;
pub use request::MoveOrigin;
pub use val3_motion::{MotionMode, MoveStage, PathPiece, PieceEnd, PieceKind};

use clients::ClientQueue;
use feedback::{Feedback, difference};

/// Maximum number of moves recorded ahead of the arm; a further move waits for the oldest move (model choice).
const CAPACITY: usize = 200;

/// Time at rest after which a compliant move continues only under another force.
const WAITING: Time = SECOND;

/// Speed of the arm when moved by hand, as a fraction of the nominal speed (model choice).
const JOG: f64 = 0.1;

/// Greatest axis distance to the destination at which an arm moved by hand has arrived, in degrees or mm.
const ARRIVED: f64 = 1e-9;

/// Distance to the path below which the arm returns to it without a request (10.6, model choice).
const DRIFT: (Millimetres, Degrees) = (Millimetres(2.0), Degrees(1.0));

/// The arm.
#[derive(Debug, Clone)]
pub struct RobotArm {
    model: Arc<Arm>,
    /// Whether the settings or the cell name the model. Otherwise it is the default model for the kind of arm.
    is_chosen: bool,
    /// Note for the user when a program first needs the arm.
    notice: Option<String>,
    motion: Motion,
    /// Instructions of the moves that are not done, by serial number.
    origins: BTreeMap<u64, MoveOrigin>,
    next_id: f64,
    clients: ClientQueue,
    /// Lines of moves whose descriptor exceeds an axis's maximum speed.
    too_fast: Vec<CodePlace>,
    connects_by_itself: bool,
    /// Whether the operator has requested the return to the path.
    connects_on_request: bool,
    /// State after the last cycle.
    sample: Sample,
    feedback: Feedback,
    latch: Option<Latch>,
    /// Joint position to which the operator moves the arm by hand.
    jog: Option<Joints>,
    /// Time for which no force has moved the arm in a compliant move.
    yielding: Time,
    /// Whether the current fault of the path was reported.
    has_reported_fault: bool,
    /// How often the arm was placed elsewhere without a motion.
    placements: u64,
}

/// Number of a move, and its instruction.
pub type CurrentMove = (f64, MoveOrigin);

/// Reason why a move is not recorded.
#[derive(Debug, Clone, PartialEq)]
pub enum MoveError {
    /// A move that was recorded before cannot be executed.
    Earlier(Cause),
    /// This move cannot be executed.
    Refused(Cause),
}

impl Default for RobotArm {
    fn default() -> Self {
        Self::of_kind(false)
    }
}

impl RobotArm {
    /// Creates the default arm of a kind, at joint position zero.
    #[must_use]
    pub(crate) fn of_kind(is_scara: bool) -> Self {
        let name = Self::default_name(is_scara);
        #[allow(clippy::expect_used, reason = "the tests of val3-kinematics load every shipped arm")]
        let model = Arm::by_name(name).expect("a shipped arm");
        let notice = format!(
            "no arm is named: this run has a {}; name yours with --arm, in val3.toml or in arm.cfx",
            model.name()
        );
        Self { is_chosen: false, notice: Some(notice), ..Self::new(model) }
    }

    /// Name of the default arm of a kind, as `getVersion` returns it.
    pub(crate) const fn default_name(is_scara: bool) -> &'static str {
        if is_scara { DEFAULT_SCARA } else { DEFAULT_SIX_AXIS }
    }

    /// Records that the cell names an unknown arm; the default arm remains.
    pub fn miss(&mut self, name: &str) {
        self.notice = Some(format!(
            "the arm `{name}` of arm.cfx is unknown: this run has a {}; describe yours in a file (--arm FILE.toml)",
            self.model.name()
        ));
    }

    /// Removes and returns the note for the user before a program uses the arm.
    pub fn take_notice(&mut self) -> Option<String> {
        self.notice.take()
    }

    /// Creates an arm of this model, at joint position zero.
    #[must_use]
    pub fn new(model: Arm) -> Self {
        let model = Arc::new(model);
        let start = [0.0; 6];
        let mut motion = Motion::new(Arc::clone(&model), start);
        let sample = motion.advance(Seconds(0.0));
        Self {
            model,
            is_chosen: true,
            notice: None,
            motion,
            origins: BTreeMap::new(),
            next_id: 0.0,
            clients: ClientQueue::default(),
            too_fast: Vec::new(),
            connects_by_itself: false,
            connects_on_request: false,
            sample,
            feedback: Feedback::at(start),
            latch: None,
            jog: None,
            yielding: 0,
            has_reported_fault: false,
            placements: 0,
        }
    }

    /// Model of the arm.
    #[must_use]
    pub fn model(&self) -> &Arm {
        &self.model
    }

    /// Model of the arm, which is another one after `setDH`.
    pub(crate) fn shared_model(&self) -> &Arc<Arm> {
        &self.model
    }

    /// How often the arm was placed elsewhere without a motion.
    pub(crate) const fn placements(&self) -> u64 {
        self.placements
    }

    /// The move that the arm executes, or at whose end it rests.
    pub(crate) fn current_move(&self) -> Option<CurrentMove> {
        let origin = self.origins.get(&self.motion.current()?)?;
        Some((self.motion.move_id().floor(), *origin))
    }

    /// Whether the settings or the cell name the model. Otherwise it is the default model for the kind of arm.
    #[must_use]
    pub const fn is_chosen(&self) -> bool {
        self.is_chosen
    }

    /// Narrows the software limits to `minArmJointPos` and `maxArmJointPos`.
    ///
    /// # Errors
    /// An axis would have an empty range.
    pub fn narrow(&mut self, lowest: &[f64], highest: &[f64]) -> Result<(), Violation> {
        let model = Arm::clone(&self.model).with_limits(lowest, highest)?;
        self.replace(model);
        Ok(())
    }

    /// `setDH`.
    ///
    /// # Errors
    /// The parameters differ too much from the parameters of the arm type.
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

    /// Sets the joint position and removes all recorded moves.
    pub fn put(&mut self, joint: Joints) {
        self.motion.place(Arc::clone(&self.model), joint);
        self.origins.clear();
        self.end_client_moves();
        self.placements += 1;
        self.sample = self.motion.advance(Seconds(0.0));
        self.feedback = Feedback::at(joint);
    }

    /// Sets the joint position like [`Self::put`], if it is within the limits.
    ///
    /// # Errors
    /// An axis would be outside its limits.
    pub fn start_at(&mut self, joint: Joints) -> Result<(), Violation> {
        self.check(&joint)?;
        self.put(joint);
        Ok(())
    }

    fn check(&self, joint: &Joints) -> Result<(), Violation> {
        self.model.violations(joint).next().map_or(Ok(()), Err)
    }

    /// `resetTurn`: the last axis gets the position nearest to its reference.
    pub fn reset_turn(&mut self, reference: &Joints) -> Joints {
        let mut joint = self.motion.joints();
        let shift = self.model.turn_shift(&joint, reference);
        if let Some(last) = self.model.axes().checked_sub(1).and_then(|last| joint.get_mut(last)) {
            *last += shift;
        }
        self.put(joint);
        joint
    }
}

/// Arm state.
impl RobotArm {
    /// Commanded joint position.
    #[must_use]
    pub fn joint(&self) -> Joints {
        self.sample.joints
    }

    /// Measured joint position.
    #[must_use]
    pub fn measured_joint(&self) -> Joints {
        self.feedback.measured()
    }

    /// State after the last cycle.
    #[must_use]
    pub const fn sample(&self) -> &Sample {
        &self.sample
    }

    /// The limit that determined the speed of the last cycle, or the reason why the arm rests.
    #[must_use]
    pub fn speed_limit(&self) -> SpeedLimit {
        self.motion.speed_limit()
    }

    /// The commanded speed of a tool centre point, in mm/s.
    #[must_use]
    pub fn speed(&self, tool: &IsometryMatrix3<f64>) -> f64 {
        self.feedback.speed(&self.model, tool)
    }

    /// `getJointForce`.
    #[must_use]
    pub fn force(&self) -> Joints {
        self.feedback.force(&self.model)
    }

    /// Whether all recorded moves are done, of programs and clients.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.motion.is_empty()
    }

    /// Whether `stopMove` holds the moves of programs.
    #[must_use]
    pub fn is_stopped(&self) -> bool {
        self.clients.programs().map_or(self.motion.is_stopped(), |programs| programs.is_stopped)
    }

    /// Whether no motion is commanded.
    #[must_use]
    pub fn is_at_rest(&self) -> bool {
        self.feedback.is_at_rest()
    }

    /// Whether the arm is settled (`isSettled`).
    #[must_use]
    pub fn is_settled(&self) -> bool {
        self.feedback.is_settled()
    }

    /// `getMoveId`.
    #[must_use]
    pub fn move_id(&self) -> f64 {
        self.clients.programs().map_or_else(|| self.motion.move_id(), |programs| programs.move_id)
    }

    /// The recorded moves that are not done, with their instructions.
    pub fn moves(&self) -> impl Iterator<Item = (&QueuedMove, Option<&MoveOrigin>)> {
        self.motion.moves().map(|queued| (queued, self.origins.get(&queued.serial)))
    }

    /// Reason why the arm does not move although moves are not done.
    #[must_use]
    pub fn hold(&self, drive: Drive) -> Option<ArmHold> {
        match self.drive_of_queue(drive) {
            _ if self.motion.is_empty() => None,
            _ if self.motion.stuck().is_some() => Some(ArmHold::Fault),
            _ if self.motion.is_stopped() && self.has_client_moves() => Some(ArmHold::StoppedByClient),
            _ if self.motion.is_stopped() => Some(ArmHold::Stopped),
            Drive { may_move: false, .. } => Some(ArmHold::Held),
            Drive { speed: Percent(0.0), .. } => Some(ArmHold::NoSpeed),
            _ if self.motion.connection().is_some() => Some(ArmHold::Away),
            _ => self.motion.waits_for_release().then_some(ArmHold::Step),
        }
    }

    /// Whether the arm yields to forces (`isCompliant`).
    #[must_use]
    pub fn is_compliant(&self) -> bool {
        self.motion.is_compliant()
    }

    /// Whether the arm is away from its path, or on a connection move.
    #[must_use]
    pub fn is_away(&self) -> bool {
        self.motion.connection().is_some() || self.sample.phase == MotionPhase::Connection
    }

    /// Whether a cycle with this drive would change the state.
    #[must_use]
    pub fn is_busy(&self, drive: Drive) -> bool {
        let drive = self.drive_of_queue(drive);
        let has_way = self.motion.can_go_on() && self.yielding < WAITING || self.may_connect(drive);
        let moves = drive.may_move && drive.speed.0 > 0.0 && has_way;
        moves
            || self.jog.is_some()
            || !self.feedback.is_quiet()
            || self.latch.as_ref().is_some_and(|latch| latch.joint().is_none())
    }
}

/// Instructions.
impl RobotArm {
    /// Records a move of the instruction at a line and returns its id; `None` while no more moves can be recorded, or
    /// the arm executes moves of clients.
    ///
    /// # Errors
    /// The move, or a move that was recorded before, cannot be executed.
    pub fn record(&mut self, request: &MoveRequest, at: CodePlace) -> Result<Option<f64>, MoveError> {
        if self.has_client_moves() {
            return Ok(None);
        }
        if let Some(cause) = self.motion.fault() {
            return Err(MoveError::Earlier(cause.clone()));
        }
        if self.is_full() {
            return Ok(None);
        }
        let id = self.next_id;
        self.append(request, id, Some(at)).map_err(MoveError::Refused)?;
        self.next_id = id + 1.0;
        Ok(Some(id))
    }

    /// `waitEndMove` at a line: the last recorded move of programs ends without a blend. Returns whether all these moves
    /// are done.
    ///
    /// # Errors
    /// A recorded move cannot be executed.
    pub fn arrive(&mut self, at: CodePlace) -> Result<bool, MoveError> {
        if self.has_client_moves() {
            return Ok(true);
        }
        self.motion.close().map_err(MoveError::Earlier)?;
        for cancelled in self.motion.moves().filter(|queued| queued.cancelled.is_some()) {
            if let Some(origin) = self.origins.get_mut(&cancelled.serial) {
                origin.cancelled_by.get_or_insert(at);
            }
        }
        Ok(self.motion.is_empty())
    }

    /// `stopMove`.
    pub fn stop(&mut self) {
        match self.clients.programs_mut() {
            Some(programs) => programs.is_stopped = true,
            None => self.motion.stop(),
        }
    }

    /// `restartMove`.
    pub fn restart(&mut self) {
        match self.clients.programs_mut() {
            Some(programs) => programs.is_stopped = false,
            None => self.motion.restart(),
        }
    }

    /// `resetMotion`: the next move starts at `start`, or at the current position of the arm.
    pub fn reset(&mut self, start: Option<Joints>) {
        self.next_id = 0.0;
        if let Some(programs) = self.clients.programs_mut() {
            programs.reset(start);
            return;
        }
        match start {
            Some(start) => self.motion.reset_to(start),
            None => self.motion.reset(),
        }
        self.origins.clear();
    }

    /// `setMoveId`: sets the id of the next move.
    pub fn set_next_move(&mut self, id: f64) {
        self.next_id = id;
    }

    /// `alterBegin`: returns its result.
    pub fn begin_alter(&mut self, reference: AlterReference, limits: &MdescValue) -> i8 {
        self.motion.alter_begin(reference, request::limits(&self.model, limits)).code()
    }

    /// `alter`: returns its result.
    pub fn alter(&mut self, transformation: &IsometryMatrix3<f64>) -> i8 {
        self.motion.alter(*transformation).code()
    }

    /// `alterEnd`: returns its result.
    pub fn end_alter(&mut self) -> i8 {
        self.motion.alter_end().code()
    }

    /// `alterStopTime`, in seconds.
    #[must_use]
    pub fn alter_stop_time(&self) -> f64 {
        self.motion.alter_stop_time().0
    }

    /// Setting of `autoConnectMove`.
    #[must_use]
    pub const fn connects_by_itself(&self) -> bool {
        self.connects_by_itself
    }

    /// Changes the setting of `autoConnectMove`.
    pub fn connect_by_itself(&mut self, active: bool) {
        self.connects_by_itself = active;
    }

    /// `setLatch`, `getLatch`.
    pub fn latch(&mut self) -> &mut Option<Latch> {
        &mut self.latch
    }
}

/// Events from outside.
impl RobotArm {
    /// Advances by one cycle.
    pub fn advance(&mut self, drive: Drive) {
        let drive = self.drive_of_queue(drive);
        if drive.may_move {
            self.motion.resume();
            self.connect(drive);
        } else {
            self.motion.brake();
        }
        self.motion.limit_tool_speed(drive.tool_speed);
        self.advance_jog();
        self.motion.set_monitor_speed(drive.speed);
        self.sample = self.motion.advance(Seconds(seconds(CYCLE)));
        let waits_for_force = self.motion.is_compliant() && self.feedback.is_at_rest();
        self.yielding = if waits_for_force { self.yielding.saturating_add(CYCLE) } else { 0 };
        self.feedback.advance(self.sample.joints);
        self.end_client_moves();
    }

    /// Removes and returns move events with their instructions.
    pub fn take_events(&mut self) -> Vec<(MoveEvent, Option<MoveOrigin>)> {
        let events = self.motion.take_events();
        events.into_iter().map(|event| (event, self.origins.get(&event.serial).copied())).collect()
    }

    /// Discards the instructions of moves that are done.
    pub(crate) fn discard_done(&mut self) {
        // The move at whose end the arm waits is needed although it is done, and so is a move that shortens a blend.
        let queued = self.motion.moves().next();
        let shortening = queued.and_then(|queued| queued.leave?.shortening?.cause());
        let queued = queued.map(|queued| queued.serial);
        let first = self.motion.current().into_iter().chain(queued).chain(shortening).min().unwrap_or(u64::MAX);
        while self.origins.first_key_value().is_some_and(|(serial, _)| *serial < first) {
            self.origins.pop_first();
        }
    }

    /// Returns the fault of the path before which the arm has come to rest since the last call, with the move's
    /// instruction.
    pub fn take_fault(&mut self) -> Option<(PathFault, Option<MoveOrigin>)> {
        let is_new = !std::mem::replace(&mut self.has_reported_fault, self.motion.stuck().is_some());
        self.motion.stuck().filter(|_| is_new).cloned().map(|fault| self.with_origin(fault))
    }

    /// The fault of the recorded path, unless [`Self::take_fault`] has returned it.
    pub fn take_unreached_fault(&mut self) -> Option<(PathFault, Option<MoveOrigin>)> {
        let is_new = !std::mem::replace(&mut self.has_reported_fault, true);
        self.motion.path_fault().filter(|_| is_new).cloned().map(|fault| self.with_origin(fault))
    }

    fn with_origin(&self, fault: PathFault) -> (PathFault, Option<MoveOrigin>) {
        let origin = self.origins.get(&fault.serial).copied();
        (fault, origin)
    }

    /// Sets the external force on the arm.
    pub fn push(&mut self, force: ExternalForce) {
        self.motion.set_external_force(force);
        self.yielding = 0;
    }

    /// Requests the return to the path, as the operator does.
    pub fn request_connection(&mut self) {
        self.connects_on_request = true;
    }

    /// Moves the arm to a joint position by hand, without effect while a program moves it.
    ///
    /// # Errors
    /// An axis would be outside its limits.
    pub fn jog(&mut self, joint: Joints) -> Result<(), Violation> {
        self.check(&joint)?;
        self.jog = Some(joint);
        Ok(())
    }

    /// Moves the arm by hand for one cycle. It stops for moves of programs, and at its destination.
    fn advance_jog(&mut self) {
        let Some(target) = self.jog else { return };
        let (present, cycle) = (self.motion.joints(), seconds(CYCLE));
        let ways: Joints = std::array::from_fn(|axis| difference(&target, &present, axis));
        let speeds = std::array::from_fn(|axis| {
            let most = JOG * self.model.nominal_speed(axis);
            (ways.get(axis).copied().unwrap_or_default() / cycle).clamp(-most, most)
        });
        let jog = Jog::Joints(speeds);
        let has_arrived = ways.iter().all(|way| way.abs() < ARRIVED);
        if has_arrived {
            // `displace` does nothing while a program moves the arm.
            self.motion.displace(target);
        }
        if has_arrived || self.motion.is_moving() || self.motion.jog(&jog, Seconds(cycle)).is_err() {
            self.jog = None;
        }
    }

    /// Starts the connection move if it is allowed (10.6).
    fn connect(&mut self, drive: Drive) {
        if self.may_connect(drive) && self.motion.connect().is_ok() {
            self.connects_on_request = false;
        }
    }

    fn may_connect(&self, drive: Drive) -> bool {
        self.motion.connection().is_some_and(|connection| {
            let (distance, rotation) = DRIFT;
            let is_near = connection.distance < distance && connection.rotation < rotation;
            drive.is_attended || is_near || self.connects_by_itself || self.connects_on_request
        })
    }
}
