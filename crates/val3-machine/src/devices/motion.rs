//! Access of instructions to the arm.

use val3_geometry::IsometryMatrix3;
use val3_kinematics::{Arm, Dh, Joints};
use val3_lang::components::{ABSOLUTE_ROBOT, ALTER, COMPLIANCE, CONTINUOUS_AXIS};
use val3_lang::fault::{Fault, Result};
use val3_lang::motion::AXIS_SPEED;
use val3_lang::ports::{CodePlace, MotionPort, MoveRequest, Time};
use val3_lang::runtime_errors::{IMPOSSIBLE_MOVE, INVALID_PARAMETER, MOTION_FAULT, NO_LICENCE, UNLINKED};
use val3_lang::values::MdescValue;
use val3_motion::{AlterReference, Manner, MoveEventKind, PathFault};

use super::Devices;
use crate::arm::{Latch, MoveError, MoveOrigin};
use crate::blend_ends::BlendEnds;
use crate::controller_state::MessageSeverity;
use crate::event::EventKind;
use crate::io::LinkId;

/// Result of the `alter` instructions without the licence (11.2.6).
const NO_ALTER: i8 = -2;

/// The inputs that have a position latch (9.2.3).
const FAST_INPUTS: [&str; 2] = ["fIn0", "fIn1"];

impl MotionPort for Devices {
    fn arm(&mut self) -> &Arm {
        if let Some(text) = self.state.arm.take_notice() {
            self.record(EventKind::Notice { text });
        }
        self.state.arm.model()
    }

    fn set_dh(&mut self, dh: &Dh) -> Result<bool> {
        self.check_licence(ABSOLUTE_ROBOT)?;
        let changed = self.state.arm.set_dh(dh);
        if let Err(error) = &changed {
            self.report_here(&format!("setDH: {error}"), MessageSeverity::Warning);
        }
        Ok(changed.is_ok())
    }

    fn commanded_joint(&mut self) -> [f64; 6] {
        if self.state.robot.is_powered() { self.state.arm.joint() } else { self.state.arm.measured_joint() }
    }

    fn measured_joint(&mut self) -> [f64; 6] {
        self.state.arm.measured_joint()
    }

    fn joint_force(&mut self) -> [f64; 6] {
        self.state.arm.force()
    }

    fn arm_latch(&mut self, input: Option<u32>) -> Result<()> {
        let input = input.ok_or(Fault(UNLINKED))?;
        let path = self.state.io.text(LinkId::from_number(input));
        if !path.rsplit('\\').next().is_some_and(|name| FAST_INPUTS.iter().any(|fast| name.eq_ignore_ascii_case(fast)))
        {
            return Err(Fault(INVALID_PARAMETER));
        }
        *self.state.arm.latch() = Some(Latch::armed(input));
        Ok(())
    }

    fn latched_joint(&mut self) -> Option<[f64; 6]> {
        self.state.arm.latch().as_ref().and_then(Latch::joint)
    }

    fn speed(&mut self, tool: &IsometryMatrix3<f64>) -> f64 {
        self.state.arm.speed(tool)
    }

    fn record_move(&mut self, request: &MoveRequest) -> Result<Option<f64>> {
        if matches!(request.manner, Manner::Compliant(_)) {
            self.check_licence(COMPLIANCE)?;
        }
        let at = self.state.record.origin().at;
        let start = self.state.arm.motion().destination();
        let recorded = self.state.arm.record(request, at);
        if let Ok(Some(id)) = recorded {
            let last = self.state.arm.moves().last();
            let blend = last.map(|(queued, origin)| self.blend_of(queued, origin)).unwrap_or_default();
            let (program, line, _) = self.place(at);
            let instruction = request.instruction;
            self.record(EventKind::Move { id, phase: "recorded", instruction, program, line, blend, target: None });
            self.warn_of_speed(request, &start, at);
        }
        recorded.map_err(|error| {
            let target = match error {
                MoveError::Refused(_) => Some(self.state.arm.target_of(request)),
                MoveError::Earlier(_) => None,
            };
            self.refuse(request.instruction, target, &error)
        })
    }

    fn is_empty(&mut self) -> bool {
        self.state.arm.is_done_for_programs()
    }

    fn is_settled(&mut self) -> bool {
        self.state.arm.is_settled()
    }

    fn is_at_rest(&mut self) -> bool {
        self.state.arm.is_at_rest()
    }

    fn is_compliant(&mut self) -> bool {
        self.state.arm.is_compliant()
    }

    fn arrive(&mut self) -> Result<bool> {
        let at = self.state.record.origin().at;
        let arrived = self.state.arm.arrive(at);
        arrived.map_err(|error| self.refuse("waitEndMove", None, &error))
    }

    fn stop_move(&mut self) {
        if !self.state.arm.is_stopped() {
            self.record_motion_here("stopped", "stopMove", None);
        }
        self.state.arm.stop();
    }

    fn restart_move(&mut self) {
        if self.state.arm.is_stopped() {
            self.record_motion_here("restarted", "restartMove", None);
        }
        self.state.arm.restart();
    }

    fn reset_motion(&mut self, start: Option<[f64; 6]>) {
        // Programs call it in loops, in which it changes nothing.
        if self.state.arm.is_stopped() || !self.state.arm.is_done_for_programs() || self.state.arm.move_id() != 0.0 {
            self.record_motion_here("reset", "resetMotion", None);
        }
        self.state.arm.reset(start);
    }

    fn reset_turn(&mut self, reference: [f64; 6]) -> Result<[f64; 6]> {
        self.check_licence(CONTINUOUS_AXIS)?;
        Ok(self.state.arm.reset_turn(&reference))
    }

    fn move_id(&mut self) -> f64 {
        self.state.arm.move_id()
    }

    fn set_move_id(&mut self, id: f64) {
        self.state.arm.set_next_move(id);
    }

    fn connects_by_itself(&mut self) -> bool {
        self.state.arm.connects_by_itself()
    }

    fn connect_by_itself(&mut self, active: bool) {
        self.state.arm.connect_by_itself(active);
    }

    fn begin_alter(&mut self, reference: AlterReference, limits: &MdescValue) -> i8 {
        if self.lacks_alter() { NO_ALTER } else { self.state.arm.begin_alter(reference, limits) }
    }

    fn alter(&mut self, transformation: &IsometryMatrix3<f64>) -> i8 {
        if self.lacks_alter() { NO_ALTER } else { self.state.arm.alter(transformation) }
    }

    fn end_alter(&mut self) -> i8 {
        self.state.arm.end_alter()
    }

    fn alter_stop_time(&mut self) -> f64 {
        self.state.arm.alter_stop_time()
    }
}

impl Devices {
    fn lacks_alter(&self) -> bool {
        self.state.versions.licence(ALTER).is_none()
    }

    /// # Errors
    /// 250 without the licence.
    fn check_licence(&self, name: &str) -> Result<()> {
        self.state.versions.licence(name).map(drop).ok_or(Fault(NO_LICENCE))
    }

    /// Reports the reason of a rejected move with its target in the event log, and returns the run-time error.
    fn refuse(&mut self, instruction: &'static str, target: Option<[f64; 3]>, error: &MoveError) -> Fault {
        let (text, code) = match error {
            MoveError::Earlier(cause) => (format!("a move recorded before cannot be done: {cause}"), MOTION_FAULT),
            MoveError::Refused(cause) => (format!("{instruction}: {cause}"), IMPOSSIBLE_MOVE),
        };
        self.report_here(&text, MessageSeverity::Error);
        self.record_motion_here("error", instruction, target);
        self.state.refusal = Some(text);
        Fault(code)
    }

    /// Warns once for each line whose descriptor exceeds the maximum speed of a moving axis.
    fn warn_of_speed(&mut self, request: &MoveRequest, start: &Joints, at: CodePlace) {
        if let Some(excess) = self.state.arm.excess_speed(request, start, at) {
            let (instruction, vel, most) = (request.instruction, request.descriptor.vel, excess.greatest_vel);
            let (program, line, _) = self.place(at);
            let text = format!(
                "{instruction} at {program}:{line}: with {AXIS_SPEED} = {vel} {excess}; use {AXIS_SPEED} = {most} at most"
            );
            self.report_here(&text, MessageSeverity::Warning);
        }
    }

    /// Records an instruction's effect on the entire motion.
    fn record_motion_here(&mut self, phase: &'static str, instruction: &'static str, target: Option<[f64; 3]>) {
        let id = self.state.arm.move_id();
        let (program, line, _) = self.place(self.state.record.origin().at);
        let blend = BlendEnds::default();
        self.record(EventKind::Move { id, phase, instruction, program, line, blend, target });
    }

    /// Records the events of moves in a cycle.
    pub(super) fn record_move_events(&mut self, now: Time) {
        for (event, origin) in self.state.arm.take_events() {
            let cancels_blend = event.kind == MoveEventKind::Done && event.cancelled.is_some();
            let shows_blend = event.kind == MoveEventKind::Blend || cancels_blend;
            if let Some(origin) = origin {
                let MoveOrigin { instruction, at, .. } = origin;
                let (program, line, _) = self.place_of_move(at);
                let blend = if shows_blend { self.blend_at(&event, Some(&origin)) } else { BlendEnds::default() };
                let (id, phase) = (event.id, event.kind.word());
                self.record_outside(
                    now,
                    EventKind::Move { id, phase, instruction, program, line, blend, target: None },
                );
            }
        }
        self.state.arm.discard_done();
    }

    /// Reports that the arm has come to rest before a path that it cannot follow.
    pub(super) fn record_motion_fault(&mut self, now: Time) {
        if let Some((fault, Some(origin))) = self.state.arm.take_fault() {
            self.report_path_fault(now, &fault, &origin, "the arm rests before a path that it cannot follow");
        }
    }

    /// Reports the unfinished moves of programs at the end of the application, and the fault of a path that the arm has not
    /// reached.
    pub(crate) fn record_dropped_moves(&mut self, now: Time) {
        if let Some((fault, Some(origin))) = self.state.arm.take_unreached_fault() {
            self.report_path_fault(now, &fault, &origin, "the arm cannot follow a recorded path");
        }
        let moves = self.state.arm.moves();
        let dropped: Vec<(f64, &'static str, CodePlace)> = moves
            .filter_map(|(queued, origin)| {
                let MoveOrigin { instruction, at, .. } = *origin?;
                Some((queued.id, instruction, at?))
            })
            .collect();
        for (id, instruction, at) in dropped {
            let (program, line, _) = self.place(at);
            let (phase, blend) = ("dropped", BlendEnds::default());
            self.record_outside(now, EventKind::Move { id, phase, instruction, program, line, blend, target: None });
        }
    }

    fn report_path_fault(&mut self, now: Time, fault: &PathFault, origin: &MoveOrigin, message: &str) {
        let (instruction, text) = (origin.instruction, fault.to_string());
        let Some(at) = origin.at else {
            // The fault belongs to the client, so the application has not failed.
            self.report(&format!("{message} ({instruction} of a client): {text}"), MessageSeverity::Error, now);
            return;
        };
        let (program, line, file) = self.place(at);
        self.report(&format!("{message} ({instruction}, {program}:{line}): {text}"), MessageSeverity::Error, now);
        let queued = self.state.arm.moves().find(|(queued, _)| queued.serial == fault.serial);
        let id = queued.map_or_else(|| self.state.arm.move_id(), |(queued, _)| queued.id);
        self.record_outside(now, EventKind::Fault { id, instruction, text, program, line, file });
    }
}
