//! Power, working mode, safety and speed of the robot (8.1).

mod results;

pub use results::{EmergencyStop, PowerRequest, RobotEvent, SpeedChange};

use val3_motion::{MillimetresPerSecond, Percent};

use super::power::{POWER_ON_TIME, Power};
use super::working_mode::{Activity, WorkingMode};
use crate::arm::Drive;

/// Maximum tool speed in manual mode if the cell sets none: reduced speed in the sense of ISO 10218-1, which is also
/// the value in the files of real cells.
const MANUAL_SPEED: MillimetresPerSecond = MillimetresPerSecond(250.0);

/// State of the robot that programs can query. It starts without power, calibrated, in remote mode, at 100 %.
#[derive(Debug, Clone, PartialEq)]
pub struct Robot {
    power: Power,
    mode: WorkingMode,
    activity: Activity,
    emergency_stop: EmergencyStop,
    safety_fault: Option<String>,
    calibrated: bool,
    monitor_speed: f64,
    /// Maximum tool speed in manual mode, and of programs in test mode below full speed.
    manual_speed: MillimetresPerSecond,
    events: Vec<RobotEvent>,
}

impl Default for Robot {
    fn default() -> Self {
        Self {
            power: Power::Off,
            mode: WorkingMode::default(),
            activity: WorkingMode::default().first_activity(),
            emergency_stop: EmergencyStop::None,
            safety_fault: None,
            calibrated: true,
            monitor_speed: 100.0,
            manual_speed: MANUAL_SPEED,
            events: Vec::new(),
        }
    }
}

/// Instructions.
impl Robot {
    /// `enablePower`: works only in remote mode. It acknowledges an emergency stop that was released, like the power
    /// key.
    pub fn enable_power(&mut self, now: u64) -> PowerRequest {
        if self.mode != WorkingMode::Remote {
            return PowerRequest::NotRemote;
        }
        match self.power {
            Power::On | Power::ComingOn { .. } => return PowerRequest::AlreadyOn,
            Power::BeingCut { .. } => return PowerRequest::BeingCut,
            Power::Off => {}
        }
        if self.es_status() == EmergencyStop::Open {
            return PowerRequest::Stopped;
        }
        self.set_emergency_stop(EmergencyStop::None);
        self.power = Power::ComingOn { at: now.saturating_add(POWER_ON_TIME) };
        PowerRequest::Started
    }

    /// `disablePower`: begins to cut the power; the instruction waits until [`Self::is_power_off`].
    pub fn disable_power(&mut self, now: u64) {
        self.change_power(self.power.cut(now));
    }

    /// Whether the arm has power (`isPowered`).
    #[must_use]
    pub fn is_powered(&self) -> bool {
        self.power.is_on()
    }

    /// Whether the power is cut and does not come on.
    #[must_use]
    pub fn is_power_off(&self) -> bool {
        self.power == Power::Off
    }

    /// Whether the power is being cut: the arm has to stop on its path.
    #[must_use]
    pub fn is_power_being_cut(&self) -> bool {
        matches!(self.power, Power::BeingCut { .. })
    }

    /// Current conditions for moves of programs.
    #[must_use]
    pub fn drive(&self) -> Drive {
        Drive {
            may_move: self.power == Power::On && self.lets_programs_move(),
            is_attended: self.mode != WorkingMode::Remote,
            speed: Percent(self.monitor_speed),
            tool_speed: self.is_slow().then_some(self.manual_speed),
        }
    }

    /// Whether neither the operator nor the working mode holds the arm.
    #[must_use]
    pub fn lets_programs_move(&self) -> bool {
        self.activity.lets_programs_move()
    }

    /// Whether the tool speed is limited as in manual mode.
    fn is_slow(&self) -> bool {
        match self.mode {
            WorkingMode::Manual => true,
            WorkingMode::Test => matches!(self.activity, Activity::Programmed | Activity::Connection),
            WorkingMode::Changing | WorkingMode::Local | WorkingMode::Remote => false,
        }
    }

    /// Sets the maximum tool speed in manual mode (`maxManuCartSpeed` of a cell).
    pub fn set_manual_speed(&mut self, speed: MillimetresPerSecond) {
        self.manual_speed = speed;
    }

    /// Notes whether the arm is away from its path.
    pub fn set_away(&mut self, is_away: bool) {
        match self.activity {
            Activity::Programmed if is_away => self.activity = Activity::Connection,
            Activity::Connection if !is_away => self.activity = Activity::Programmed,
            _ => {}
        }
    }

    /// Whether all axes are calibrated (`isCalibrated`).
    #[must_use]
    pub fn is_calibrated(&self) -> bool {
        self.calibrated
    }

    /// `workingMode`.
    #[must_use]
    pub fn working_mode(&self) -> WorkingMode {
        self.mode
    }

    /// State within the mode, as `workingMode(nStatus)` returns it.
    #[must_use]
    pub fn mode_state(&self) -> u8 {
        self.mode.state(self.activity)
    }

    /// `esStatus`.
    #[must_use]
    pub fn es_status(&self) -> EmergencyStop {
        if self.safety_fault.is_some() { EmergencyStop::Open } else { self.emergency_stop }
    }

    /// `safetyFault`: the name of the faulty signal; `None` for `false`.
    #[must_use]
    pub fn safety_fault(&self) -> Option<&str> {
        self.safety_fault.as_deref()
    }

    /// `getMonitorSpeed`, per cent.
    #[must_use]
    pub fn monitor_speed(&self) -> f64 {
        self.monitor_speed
    }

    /// `setMonitorSpeed`. `operator_controls`: whether the active profile assigns the speed keys to the operator, and a
    /// pendant is connected.
    pub fn set_monitor_speed(&mut self, speed: f64, operator_controls: bool) -> SpeedChange {
        if !(0.0..=100.0).contains(&speed) {
            return SpeedChange::OutOfRange;
        }
        if speed > self.monitor_speed {
            if self.mode != WorkingMode::Remote {
                return SpeedChange::NotRemote;
            }
            if operator_controls {
                return SpeedChange::OperatorControls;
            }
        }
        self.turn_speed_to(speed);
        SpeedChange::Done
    }
}

/// Effects from outside on the robot. Times are in nanoseconds.
impl Robot {
    /// Advances the time. The power is cut only when `arm_stands`.
    pub fn advance(&mut self, now: u64, arm_stands: bool) {
        self.change_power(self.power.after(now, arm_stands));
    }

    /// The time of the next change of the power. A moving arm can delay it.
    #[must_use]
    pub fn next_due(&self) -> Option<u64> {
        self.power.due()
    }

    /// The events since the last call.
    pub fn take_events(&mut self) -> Vec<RobotEvent> {
        std::mem::take(&mut self.events)
    }

    /// Switches the power on or off immediately, in any mode; on only without an emergency stop.
    pub fn set_power(&mut self, on: bool) {
        if !on {
            self.change_power(Power::Off);
        } else if self.es_status() != EmergencyStop::Open {
            self.set_emergency_stop(EmergencyStop::None);
            self.change_power(Power::On);
        }
    }

    /// Changes the working mode. The power is cut, as on every change of the mode; the arm is held unless the mode is
    /// remote.
    pub fn set_mode(&mut self, mode: WorkingMode, now: u64) {
        if self.mode != mode {
            self.mode = mode;
            self.activity = mode.first_activity();
            self.events.push(RobotEvent::Mode(mode));
            self.disable_power(now);
        }
    }

    /// Sets the current activity of the arm.
    pub fn set_activity(&mut self, activity: Activity) {
        self.activity = activity;
    }

    /// Allows moves of programs, or holds the arm, as the operator does (the key Move/Hold). In test mode programs then
    /// move the arm at full speed.
    pub fn let_move(&mut self, allowed: bool) {
        self.activity = match self.mode {
            _ if !allowed => Activity::Hold,
            WorkingMode::Test => Activity::FastProgrammed,
            _ => Activity::Programmed,
        };
    }

    /// Presses the emergency stop: the power is off immediately.
    pub fn press_emergency_stop(&mut self) {
        self.set_emergency_stop(EmergencyStop::Open);
        self.change_power(Power::Off);
    }

    /// Releases the emergency stop, which then waits to be acknowledged.
    pub fn release_emergency_stop(&mut self) {
        if self.emergency_stop == EmergencyStop::Open {
            self.set_emergency_stop(EmergencyStop::Released);
        }
    }

    /// Acknowledges a released emergency stop.
    pub fn acknowledge_emergency_stop(&mut self) {
        if self.emergency_stop == EmergencyStop::Released {
            self.set_emergency_stop(EmergencyStop::None);
        }
    }

    /// Sets or ends a fault of the safety circuit, by the name of the signal. A fault cuts the power like an emergency
    /// stop.
    pub fn set_safety_fault(&mut self, signal: Option<String>) {
        let before = self.es_status();
        self.safety_fault = signal;
        let after = self.es_status();
        if before != after {
            self.events.push(RobotEvent::EmergencyStop(after));
        }
        if after == EmergencyStop::Open {
            self.change_power(Power::Off);
        }
    }

    /// Sets whether all axes are calibrated.
    pub fn set_calibrated(&mut self, calibrated: bool) {
        self.calibrated = calibrated;
    }

    /// Changes the monitor speed as the operator does, in any mode; it is limited to 0 and 100 %.
    pub fn turn_speed(&mut self, speed: f64) {
        self.turn_speed_to(speed.clamp(0.0, 100.0));
    }

    fn turn_speed_to(&mut self, speed: f64) {
        if self.monitor_speed != speed {
            self.monitor_speed = speed;
            self.events.push(RobotEvent::MonitorSpeed(speed));
        }
    }

    fn set_emergency_stop(&mut self, state: EmergencyStop) {
        let before = self.es_status();
        self.emergency_stop = state;
        if self.es_status() != before {
            self.events.push(RobotEvent::EmergencyStop(self.es_status()));
        }
    }

    fn change_power(&mut self, power: Power) {
        if self.power.is_on() != power.is_on() {
            self.events.push(RobotEvent::Power(power.is_on()));
        }
        self.power = power;
    }
}

#[cfg(test)]
mod tests;
