//! Access of programs to inputs and outputs (3.5.3, 3.6.2).

use super::signal::{Direction, SignalKind, SignalRange};
use super::status::{IoError, IoStatus, SignalFault};
use super::table::{Channel, IoTable, LinkId, SignalId};

/// Any `aio` variable.
const ANALOG: SignalKind = SignalKind::Analog(SignalRange::Float);

impl IoTable {
    /// Reads a `dio` variable.
    ///
    /// # Errors
    /// 123 not linked, 125 its device has failed.
    pub fn read_digital(&self, link: LinkId) -> Result<bool, IoError> {
        self.read(link, SignalKind::Digital).map(|value| value != 0.0)
    }

    /// `aioGet`.
    ///
    /// # Errors
    /// 123 not linked, 125 its device has failed.
    pub fn read_analog(&self, link: LinkId) -> Result<f64, IoError> {
        self.read(link, ANALOG)
    }

    /// Writes a digital output; a locked output keeps its value.
    ///
    /// # Errors
    /// 122 an input, 123 not linked, 124 an output of the system, 125 its device has failed.
    pub fn write_digital(&mut self, link: LinkId, value: bool) -> Result<(), IoError> {
        self.write(link, SignalKind::Digital, f64::from(u8::from(value))).map(|_| ())
    }

    /// `aioSet`: writes an analog output and returns the resulting value: rounded and limited to its range, or the
    /// value at which it is locked.
    ///
    /// # Errors
    /// 122 an input, 123 not linked, 124 an output of the system, 125 its device has failed.
    pub fn write_analog(&mut self, link: LinkId, value: f64) -> Result<f64, IoError> {
        self.write(link, ANALOG, value)
    }

    /// `dioGet`: returns the signals as a binary number, the first signal as the lowest bit.
    ///
    /// # Errors
    /// 123 a signal that is not linked, 125 a signal whose device has failed.
    pub fn read_bits(&self, links: &[LinkId]) -> Result<f64, IoError> {
        let mut number = 0.0;
        for link in links.iter().rev() {
            number = number * 2.0 + self.read(*link, SignalKind::Digital)?;
        }
        Ok(number)
    }

    /// `dioSet`: writes the integer part of `value` in binary, the lowest bit first, and returns the resulting number
    /// of the outputs. Bits beyond the array are dropped; a negative number is written in two's complement. If one
    /// signal cannot be written, no signal is written.
    ///
    /// # Errors
    /// 122 an input, 123 a signal that is not linked, 124 an output of the system, 125 a signal whose device has
    /// failed.
    pub fn write_bits(&mut self, links: &[LinkId], value: f64) -> Result<f64, IoError> {
        for link in links {
            self.writable(*link, SignalKind::Digital)?;
        }
        let mut rest = value.trunc();
        for link in links {
            let bit = rest.rem_euclid(2.0);
            self.write(*link, SignalKind::Digital, bit)?;
            rest = (rest - bit) / 2.0;
        }
        self.read_bits(links)
    }

    /// `ioStatus` for a `dio` variable.
    #[must_use]
    pub fn digital_status(&self, link: LinkId) -> IoStatus {
        self.status(link, SignalKind::Digital)
    }

    /// `ioStatus` for an `aio` variable.
    #[must_use]
    pub fn analog_status(&self, link: LinkId) -> IoStatus {
        self.status(link, ANALOG)
    }

    /// Description that `ioStatus` returns with the status; empty if the link is unresolved. The physical path is
    /// [`IoTable::text`].
    #[must_use]
    pub fn description(&self, link: LinkId) -> &str {
        self.signal_of(link).map_or("", |signal| signal.description.as_str())
    }

    fn status(&self, link: LinkId, kind: SignalKind) -> IoStatus {
        if link == LinkId::NONE {
            return IoStatus::Unlinked;
        }
        let channel = self.target(link, kind).and_then(|id| self.channel(id));
        channel.map_or(IoStatus::Absent, |channel| self.status_of(channel))
    }

    /// A fault precedes a lock, and a lock the simulation.
    pub(super) fn status_of(&self, channel: &Channel) -> IoStatus {
        match self.fault_of(channel) {
            Some(SignalFault::Absent) => IoStatus::Absent,
            Some(SignalFault::Failed) => IoStatus::Failed,
            None if channel.lock.is_some() => IoStatus::Locked,
            None if channel.simulated => IoStatus::Simulated,
            None => IoStatus::Works,
        }
    }

    fn read(&self, link: LinkId, kind: SignalKind) -> Result<f64, IoError> {
        let channel = self.target(link, kind).and_then(|id| self.channel(id)).ok_or(IoError::Unlinked)?;
        match self.fault_of(channel) {
            Some(SignalFault::Absent) => Err(IoError::Unlinked),
            Some(SignalFault::Failed) => Err(IoError::NoAnswer),
            None => Ok(channel.image),
        }
    }

    fn write(&mut self, link: LinkId, kind: SignalKind, value: f64) -> Result<f64, IoError> {
        let id = self.writable(link, kind)?;
        let channel = self.channel_mut(id).ok_or(IoError::Unlinked)?;
        let value = channel.signal.kind.fit(value);
        if channel.signal.direction == Direction::Input {
            channel.hardware = value;
        }
        if channel.lock.is_none() {
            channel.image = value;
        }
        let image = channel.image;
        self.to_refresh.insert(id);
        Ok(image)
    }

    fn writable(&self, link: LinkId, kind: SignalKind) -> Result<SignalId, IoError> {
        let id = self.target(link, kind).ok_or(IoError::Unlinked)?;
        let channel = self.channel(id).ok_or(IoError::Unlinked)?;
        match self.fault_of(channel) {
            Some(SignalFault::Absent) => Err(IoError::Unlinked),
            _ if channel.signal.direction == Direction::Input && !self.forces_inputs => Err(IoError::WriteToInput),
            _ if channel.signal.protected => Err(IoError::Protected),
            Some(SignalFault::Failed) => Err(IoError::NoAnswer),
            None => Ok(id),
        }
    }
}

#[cfg(test)]
mod tests;
