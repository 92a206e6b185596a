//! Access of instructions to inputs and outputs (3.5, 3.6, 8.1).

use val3_lang::fault::{Fault, Result};
use val3_lang::ports::{IoDescription, IoPort};
use val3_lang::types::BaseType;
use val3_lang::values::Text;

use super::Devices;
use crate::io::{IoError, LinkId};

impl IoPort for Devices {
    fn read_digital(&mut self, port: Option<u32>) -> Result<bool> {
        self.note_read(link(port));
        self.state.io.read_digital(link(port)).map_err(fault)
    }

    fn write_digital(&mut self, port: Option<u32>, value: bool) -> Result<()> {
        self.state.io.write_digital(link(port), value).map_err(fault)
    }

    fn read_bits(&mut self, ports: &[Option<u32>]) -> Result<f64> {
        let links = links(ports);
        links.iter().for_each(|link| self.note_read(*link));
        self.state.io.read_bits(&links).map_err(fault)
    }

    fn write_bits(&mut self, ports: &[Option<u32>], value: f64) -> Result<f64> {
        self.state.io.write_bits(&links(ports), value).map_err(fault)
    }

    fn read_analog(&mut self, port: Option<u32>) -> Result<f64> {
        self.note_read(link(port));
        self.state.io.read_analog(link(port)).map_err(fault)
    }

    fn write_analog(&mut self, port: Option<u32>, value: f64) -> Result<f64> {
        self.state.io.write_analog(link(port), value).map_err(fault)
    }

    fn io_status(&mut self, base: BaseType, port: Option<u32>) -> i8 {
        let status = match base {
            BaseType::Dio => self.state.io.digital_status(link(port)),
            _ => self.state.io.analog_status(link(port)),
        };
        status.number()
    }

    fn io_texts(&mut self, port: Option<u32>) -> IoDescription {
        let link = link(port);
        IoDescription {
            description: Text::from(self.state.io.description(link)),
            path: Text::from(self.state.io.text(link)),
        }
    }

    fn failed_devices(&mut self) -> Vec<Text> {
        self.state.io.bus_faults().iter().map(|fault| Text::from(fault.as_str())).collect()
    }
}

impl Devices {
    /// Link of a `dio`, `aio` or `sio` variable; `None` without a link.
    #[must_use]
    pub fn port_name(&self, base: BaseType, port: u32) -> Option<&str> {
        match base {
            BaseType::Sio => self.lines.link(port),
            _ => Some(self.state.io.text(LinkId::from_number(port))),
        }
    }

    /// Whether the line of a `sio` variable is configured, by the cell or an argument.
    #[must_use]
    pub fn has_line(&self, port: u32) -> bool {
        self.lines.is_configured(port)
    }

    /// State of a `sio` variable's line, shown to users.
    #[must_use]
    pub fn line_state(&self, port: u32) -> &'static str {
        self.lines.state_of(port)
    }

    /// Reads a `dio` variable.
    ///
    /// # Errors
    /// 123 not linked, 125 its device has failed.
    pub fn digital(&self, port: u32) -> Result<bool> {
        self.state.io.read_digital(LinkId::from_number(port)).map_err(fault)
    }

    /// Reads an `aio` variable.
    ///
    /// # Errors
    /// 123 not linked, 125 its device has failed.
    pub fn analog(&self, port: u32) -> Result<f64> {
        self.state.io.read_analog(LinkId::from_number(port)).map_err(fault)
    }
}

fn link(port: Option<u32>) -> LinkId {
    port.map_or(LinkId::NONE, LinkId::from_number)
}

fn links(ports: &[Option<u32>]) -> Vec<LinkId> {
    ports.iter().copied().map(link).collect()
}

fn fault(error: IoError) -> Fault {
    Fault(error.number())
}
