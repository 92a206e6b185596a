//! Inputs and outputs as instructions reach them.

use val3_lang::fault::{Fault, Result};
use val3_lang::ports::Io;

use super::Devices;
use crate::io::{IoError, LinkId};

impl Io for Devices {
    fn read_digital(&mut self, port: Option<u32>) -> Result<bool> {
        self.io.read_digital(link(port)).map_err(fault)
    }

    fn write_digital(&mut self, port: Option<u32>, value: bool) -> Result<()> {
        self.io.write_digital(link(port), value).map_err(fault)
    }
}

fn link(port: Option<u32>) -> LinkId {
    port.map_or(LinkId::NONE, LinkId::from_number)
}

fn fault(error: IoError) -> Fault {
    Fault(error.number())
}
