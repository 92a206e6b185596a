//! The state of the devices: plain data that a snapshot copies.

use std::collections::BTreeSet;

use val3_cell::{Handling, Watch};
use val3_kinematics::Arm;
use val3_lang::components::Component;
use val3_lang::ports::Time;

use super::loaded::LoadedProjects;
use super::media_cost::MediaCost;
use super::questions::Questions;
use super::record::Record;
use crate::arm::{ArmHold, CurrentMove, RobotArm};
use crate::controller_state::{Calendar, ControllerVersions, Cs9, EventLog, Languages, Profiles, Robot};
use crate::io::{IoTable, LinkId};
use crate::screen::Pendant;

/// The state of the devices.
#[derive(Debug, Clone, Default)]
pub struct DeviceState {
    /// Digital and analog inputs and outputs.
    pub io: IoTable,
    /// The pendant.
    pub pendant: Pendant,
    /// Power, modes and speed.
    pub robot: Robot,
    /// The arm.
    pub arm: RobotArm,
    /// The things around the arm, if a cell describes them.
    pub watch: Option<Watch<Option<CurrentMove>>>,
    /// The parts around the arm with their grippers and sensors, if a cell describes any.
    pub handling: Option<Handling>,
    /// Inputs that both the cell and a script have written.
    pub(crate) written_twice: BTreeSet<String>,
    /// The event log.
    pub log: EventLog,
    /// Users.
    pub profiles: Profiles,
    /// Languages.
    pub languages: Languages,
    /// Versions and licences.
    pub versions: ControllerVersions,
    /// Date and time.
    pub calendar: Calendar,
    /// Additional features of CS9 controllers.
    pub cs9: Cs9,
    /// Events that the caller has not taken.
    pub(super) record: Record,
    /// The applications and libraries in memory.
    pub(super) loaded: LoadedProjects,
    /// Questions on the pendant for which tasks wait.
    pub(super) questions: Questions,
    /// Reason why the last move was rejected, for the error of its task.
    pub(super) refusal: Option<String>,
    /// Time that the last instruction has spent outside the program.
    pub(super) media_cost: MediaCost,
    /// Whether a task has reached an instruction that this controller does not support.
    pub(super) lacks: bool,
}

impl DeviceState {
    /// Sets the arm, with the name that `getVersion` returns.
    pub fn set_arm(&mut self, model: Arm, name: &str) {
        self.versions.set(Component::ArmType, name);
        self.arm = RobotArm::new(model);
    }

    /// Sets the default arm of a kind.
    pub fn set_default_arm(&mut self, is_scara: bool) {
        self.versions.set(Component::ArmType, RobotArm::default_name(is_scara));
        self.arm = RobotArm::of_kind(is_scara);
    }

    /// Advances the arm by one cycle, and then its power.
    pub(super) fn advance_arm(&mut self, now: Time) {
        self.arm.advance(self.robot.drive());
        self.robot.set_away(self.arm.is_away());
        self.robot.advance(now, self.arm.is_at_rest());
    }

    /// Reason why the arm does not move although moves are not done.
    #[must_use]
    pub fn arm_hold(&self) -> Option<ArmHold> {
        let hold = self.arm.hold(self.robot.drive())?;
        Some(if self.robot.is_powered() { hold } else { ArmHold::NoPower })
    }

    /// Reason why the arm does not move to the end of the release.
    #[must_use]
    pub fn arm_standstill(&self) -> Option<ArmHold> {
        let hold = self.arm.standstill(self.robot.drive())?;
        Some(if self.robot.is_powered() { hold } else { ArmHold::NoPower })
    }

    /// Passes the input signal to the latch.
    pub(super) fn watch_latch(&mut self) {
        let joint = self.arm.measured_joint();
        if let Some(latch) = self.arm.latch() {
            let is_high = self.io.read_digital(LinkId::from_number(latch.input())).unwrap_or(false);
            latch.see(is_high, joint);
        }
    }
}
