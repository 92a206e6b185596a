//! Effects on inputs and outputs from outside the programs: hardware, operator, faults.

use super::signal::Direction;
use super::status::SignalFault;
use super::table::{Channel, IoTable, SignalId};

/// Interventions of the operator and the controller in a signal, and its faults.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Forcing {
    /// The operator holds it at a value.
    pub is_locked: bool,
    /// The controller simulates it.
    pub is_simulated: bool,
    /// It fails.
    pub fault: Option<SignalFault>,
}

/// The hardware and the operator.
impl IoTable {
    /// The hardware sets a signal. Programs see an input of this value from the next cycle on; an output has it at
    /// once, as when the other side of a field bus writes it.
    pub fn set(&mut self, id: SignalId, value: f64) {
        self.change(id, |channel| {
            let value = channel.signal.kind.fit(value);
            channel.hardware = value;
            if channel.signal.direction == Direction::Output && channel.lock.is_none() {
                channel.image = value;
            }
        });
    }

    /// The value at the terminal: an input's forced value, an output's last written value.
    #[must_use]
    pub fn hardware(&self, id: SignalId) -> Option<f64> {
        self.channel(id).map(|channel| channel.hardware)
    }

    /// The value that programs see.
    #[must_use]
    pub fn image(&self, id: SignalId) -> Option<f64> {
        self.channel(id).map(|channel| channel.image)
    }

    /// The interventions in a signal.
    #[must_use]
    pub fn forcing(&self, id: SignalId) -> Option<Forcing> {
        let channel = self.channel(id)?;
        Some(Forcing { is_locked: channel.lock.is_some(), is_simulated: channel.simulated, fault: channel.fault })
    }

    /// The operator holds a signal at `value`, or at the value it has. Of an input, programs see this value whatever
    /// the hardware says; of an output, what programs write has no effect.
    pub fn lock(&mut self, id: SignalId, value: Option<f64>) {
        self.change(id, |channel| {
            let value = value.map_or(channel.image, |value| channel.signal.kind.fit(value));
            channel.lock = Some(value);
            if channel.signal.direction == Direction::Output {
                channel.image = value;
            }
        });
    }

    /// The operator lets a signal go. An input follows the hardware again; an output keeps its value until it is
    /// written.
    pub fn unlock(&mut self, id: SignalId) {
        self.change(id, |channel| channel.lock = None);
    }

    /// Simulates a signal, or no longer. The hardware does not get a simulated output; a simulated input is set as any
    /// other.
    pub fn simulate(&mut self, id: SignalId, simulated: bool) {
        self.change(id, |channel| channel.simulated = simulated);
    }

    /// Reserves an output for the system, or frees it. Programs that write a reserved output get run-time error 124.
    pub fn protect(&mut self, id: SignalId, protected: bool) {
        self.change(id, |channel| channel.signal.protected = protected);
    }

    /// A signal fails, or works again; its values stay.
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
