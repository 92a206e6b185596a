//! Serial line of the operating system: a port, or a pseudo terminal in its place.

use std::fs::OpenOptions;
use std::io::{self, ErrorKind, Read, Write};
use std::os::unix::fs::OpenOptionsExt;

use camino::Utf8Path;
use rustix::termios::{ControlModes, OptionalActions, Termios, tcgetattr, tcsetattr};

use super::{ByteStream, Connection, LineKind, LineSetting, Parity, Received, SendResult, SettingRefusal};

/// Serial line, which is always open (3.7.1).
#[derive(Debug)]
pub struct SerialLine {
    port: std::fs::File,
}

impl SerialLine {
    /// Opens the device for unchanged bytes: no echo, no conversion of line ends.
    ///
    /// # Errors
    /// If the device does not exist, or is no serial line.
    pub fn open(device: &Utf8Path) -> io::Result<Self> {
        let flags = rustix::fs::OFlags::NOCTTY | rustix::fs::OFlags::NONBLOCK;
        let flags = i32::try_from(flags.bits()).map_err(|_| ErrorKind::Unsupported)?;
        let port = OpenOptions::new().read(true).write(true).custom_flags(flags).open(device)?;
        let mut modes = tcgetattr(&port)?;
        modes.make_raw();
        modes.control_modes |= ControlModes::CLOCAL | ControlModes::CREAD;
        tcsetattr(&port, OptionalActions::Now, &modes)?;
        Ok(Self { port })
    }

    fn change(&self, change: impl FnOnce(&mut Termios) -> rustix::io::Result<()>) -> Result<(), SettingRefusal> {
        let mut modes = tcgetattr(&self.port).map_err(|_| SettingRefusal::Value)?;
        change(&mut modes)
            .and_then(|()| tcsetattr(&self.port, OptionalActions::Now, &modes))
            .map_err(|_| SettingRefusal::Value)
    }

    fn set_flags(&self, mask: ControlModes, flags: ControlModes) -> Result<(), SettingRefusal> {
        self.change(|modes| {
            modes.control_modes.remove(mask);
            modes.control_modes.insert(flags);
            Ok(())
        })
    }
}

fn bits(count: u8) -> ControlModes {
    match count {
        5 => ControlModes::CS5,
        6 => ControlModes::CS6,
        7 => ControlModes::CS7,
        _ => ControlModes::CS8,
    }
}

fn parity(parity: Parity) -> ControlModes {
    match parity {
        Parity::None => ControlModes::empty(),
        Parity::Even => ControlModes::PARENB,
        Parity::Odd => ControlModes::PARENB | ControlModes::PARODD,
    }
}

/// Returns the flag, or no flag.
fn only(flag: ControlModes, on: bool) -> ControlModes {
    if on { flag } else { ControlModes::empty() }
}

impl ByteStream for SerialLine {
    fn kind(&self) -> LineKind {
        LineKind::Serial
    }

    fn open(&mut self) -> Connection {
        Connection::Open
    }

    /// A line without a peer is silent.
    fn receive(&mut self, room: usize, _fresh: bool) -> Received {
        let mut bytes = vec![0; room.min(4_096)];
        match self.port.read(&mut bytes) {
            Ok(count) if count > 0 => {
                bytes.truncate(count);
                Received::Bytes(bytes)
            }
            _ => Received::Nothing,
        }
    }

    fn send(&mut self, bytes: &[u8]) -> SendResult {
        match self.port.write(bytes) {
            Ok(count) => SendResult::Taken(count),
            Err(error) if matches!(error.kind(), ErrorKind::WouldBlock | ErrorKind::Interrupted) => {
                SendResult::Taken(0)
            }
            Err(_) => SendResult::Lost,
        }
    }

    fn close(&mut self) -> bool {
        false
    }

    fn shut_down(&mut self) {}

    /// The line has only RS-232 drivers.
    fn apply(&mut self, setting: &LineSetting) -> Result<(), SettingRefusal> {
        match setting {
            LineSetting::BaudRate(0) | LineSetting::Rs422(true) => Err(SettingRefusal::Value),
            LineSetting::BaudRate(rate) => self.change(|modes| modes.set_speed(*rate)),
            LineSetting::Bits(count) => self.set_flags(ControlModes::CSIZE, bits(*count)),
            LineSetting::Parity(kind) => self.set_flags(ControlModes::PARENB | ControlModes::PARODD, parity(*kind)),
            LineSetting::StopBits(count) => {
                self.set_flags(ControlModes::CSTOPB, only(ControlModes::CSTOPB, *count == 2))
            }
            LineSetting::HardwareFlow(on) => self.set_flags(ControlModes::CRTSCTS, only(ControlModes::CRTSCTS, *on)),
            LineSetting::Rs422(false) => Ok(()),
            _ => Err(SettingRefusal::Value),
        }
    }
}

#[cfg(target_os = "linux")]
#[cfg(test)]
mod tests;
