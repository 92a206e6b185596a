//! Results of instructions on the robot, and its events.

use crate::controller_state::WorkingMode;

/// The emergency stop circuit; the number is the result of `esStatus`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[repr(u8)]
pub enum EmergencyStop {
    /// 0: no emergency stop.
    #[default]
    None = 0,
    /// 1: released, not yet acknowledged.
    Released = 1,
    /// 2: the circuit is open, or a fault of the hardware has to be repaired.
    Open = 2,
}

/// The result of `enablePower`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PowerRequest {
    /// The power comes on.
    Started,
    /// The power is on, or coming on.
    AlreadyOn,
    /// The robot is not in remote mode.
    NotRemote,
    /// The power is being cut.
    BeingCut,
    /// An emergency stop or a safety fault keeps the power off.
    Stopped,
}

impl PowerRequest {
    /// Line of the event log for a request without effect.
    #[must_use]
    pub fn refusal(self) -> Option<&'static str> {
        match self {
            Self::Started | Self::AlreadyOn => None,
            Self::NotRemote => Some("arm power not switched on: the robot is not in remote mode"),
            Self::BeingCut => Some("arm power not switched on: it is being cut"),
            Self::Stopped => Some("arm power not switched on: emergency stop"),
        }
    }
}

/// Result of `setMonitorSpeed`; the number is the result in a program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(i8)]
pub enum SpeedChange {
    /// The speed is changed.
    Done = 0,
    /// The speed would be higher, and the robot is not in remote mode.
    NotRemote = -1,
    /// The speed would be higher, and the operator controls it.
    OperatorControls = -2,
    /// The speed is not between 0 and 100.
    OutOfRange = -3,
}

/// Event of the robot.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum RobotEvent {
    /// The power was switched on or off.
    Power(bool),
    /// New working mode.
    Mode(WorkingMode),
    /// New state of the emergency stop circuit.
    EmergencyStop(EmergencyStop),
    /// New monitor speed, in per cent.
    MonitorSpeed(f64),
}
