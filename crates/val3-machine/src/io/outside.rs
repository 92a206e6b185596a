//! Effects on inputs and outputs from outside the programs: hardware, operator, faults.

use super::signal::Direction;
use super::status::SignalFault;
use super::table::{Channel, IoTable, SignalId};

/// Interventions of the operator and the controller in a signal, and its faults.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Forcing {
    /// Whether the operator locks the signal at a value.
    pub is_locked: bool,
    /// Whether the controller simulates the signal.
    pub is_simulated: bool,
    /// Fault of the signal.
    pub fault: Option<SignalFault>,
}

/// The hardware and the operator.
impl IoTable {
    /// Sets a signal like the hardware. Programs read an input's new value from the next cycle on; an output has the
    /// value immediately, as after a write from the other side of a field bus.
    pub fn set(&mut self, id: SignalId, value: f64) {
        self.change(id, |channel| {
            let value = channel.signal.kind.fit(value);
            channel.hardware = value;
            if channel.signal.direction == Direction::Output && channel.lock.is_none() {
                channel.image = value;
            }
        });
    }

    /// Sets whether writes of programs set inputs like the hardware, instead of failing with run-time error 122. A
    /// debugger switches it on for an assignment of its user, who forces an input with it.
    pub fn force_inputs(&mut self, is_wanted: bool) {
        self.forces_inputs = is_wanted;
    }

    /// Value at the terminal: the forced value of the input, the last written value of the output.
    #[must_use]
    pub fn hardware(&self, id: SignalId) -> Option<f64> {
        self.channel(id).map(|channel| channel.hardware)
    }

    /// Value that programs read.
    #[must_use]
    pub fn image(&self, id: SignalId) -> Option<f64> {
        self.channel(id).map(|channel| channel.image)
    }

    /// Value that programs read from the next cycle on: the locked value, otherwise the value at the terminal of an
    /// input or the last written value of an output. Unlike [`IoTable::image`], it is current while the run is stopped.
    #[must_use]
    pub fn next_image(&self, id: SignalId) -> Option<f64> {
        let channel = self.channel(id)?;
        let unlocked = match channel.signal.direction {
            Direction::Input => channel.hardware,
            Direction::Output => channel.image,
        };
        Some(channel.lock.unwrap_or(unlocked))
    }

    /// Interventions in a signal.
    #[must_use]
    pub fn forcing(&self, id: SignalId) -> Option<Forcing> {
        let channel = self.channel(id)?;
        Some(Forcing { is_locked: channel.lock.is_some(), is_simulated: channel.simulated, fault: channel.fault })
    }

    /// Locks a signal at `value`, or at its current value, as the operator does. Programs read the locked value of the
    /// input independent of the hardware; writing a locked output has no effect.
    pub fn lock(&mut self, id: SignalId, value: Option<f64>) {
        self.change(id, |channel| {
            let value = value.map_or(channel.image, |value| channel.signal.kind.fit(value));
            channel.lock = Some(value);
            if channel.signal.direction == Direction::Output {
                channel.image = value;
            }
        });
    }

    /// Unlocks a signal, as the operator does. An input follows the hardware again; an output keeps its value until it
    /// is written.
    pub fn unlock(&mut self, id: SignalId) {
        self.change(id, |channel| channel.lock = None);
    }

    /// Starts or ends the simulation of a signal. The hardware does not receive a simulated output; a simulated input
    /// is set like any other input.
    pub fn simulate(&mut self, id: SignalId, simulated: bool) {
        self.change(id, |channel| channel.simulated = simulated);
    }

    /// Reserves an output for the system, or frees it. Writing a reserved output raises run-time error 124 in programs.
    pub fn protect(&mut self, id: SignalId, protected: bool) {
        self.change(id, |channel| channel.signal.protected = protected);
    }

    /// Sets or clears the fault of a signal; its values stay.
    pub fn set_fault(&mut self, id: SignalId, fault: Option<SignalFault>) {
        self.change(id, |channel| channel.fault = fault);
    }

    fn change(&mut self, id: SignalId, change: impl FnOnce(&mut Channel)) {
        if let Some(channel) = self.channel_mut(id) {
            change(channel);
            self.to_refresh.insert(id);
        }
    }
}
