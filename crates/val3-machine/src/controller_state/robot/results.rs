//! The results of instructions on the robot, and its events.

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
    /// It is on, or coming on.
    AlreadyOn,
    /// The robot is not in remote mode.
    NotRemote,
    /// The power is being cut.
    BeingCut,
    /// An emergency stop or a safety fault keeps it off.
    Stopped,
}

impl PowerRequest {
    /// The line of the event log about a request without effect.
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

/// How `setMonitorSpeed` ended; the number is its result.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(i8)]
pub enum SpeedChange {
    /// The speed is changed.
    Done = 0,
    /// It would be higher, and the robot is not in remote mode.
    NotRemote = -1,
    /// It would be higher, and the operator controls the speed.
    OperatorControls = -2,
    /// It is not between 0 and 100.
    OutOfRange = -3,
}

/// An event of the robot.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum RobotEvent {
    /// The power is on or off.
    Power(bool),
    /// Another working mode.
    Mode(WorkingMode),
    /// Another state of the emergency stop circuit.
    EmergencyStop(EmergencyStop),
    /// Another monitor speed, in per cent.
    MonitorSpeed(f64),
}
