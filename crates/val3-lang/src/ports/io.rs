//! Inputs, outputs and serial lines (3.5 to 3.7). A variable contains the port number as link (`Link::Port`).

use crate::fault::Result;
use crate::types::BaseType;
use crate::values::Text;

/// Texts that `ioStatus` returns in addition to the status.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct IoDescription {
    /// Free text from the configuration; empty if the link does not resolve.
    pub description: Text,
    /// Target of the variable's link.
    pub path: Text,
}

/// Inputs, outputs and serial lines of the controller.
pub trait IoPort {
    /// Reads a digital input or output.
    ///
    /// # Errors
    /// 123 without a link, 125 if the device does not respond.
    fn read_digital(&mut self, port: Option<u32>) -> Result<bool>;

    /// Sets a digital output.
    ///
    /// # Errors
    /// 122 for an input, 123 without a link, 124 for an output of the system, 125 if the device does not respond.
    fn write_digital(&mut self, port: Option<u32>, value: bool) -> Result<()>;

    /// Reads digital inputs or outputs as a binary number; the first is the lowest bit (`dioGet`).
    ///
    /// # Errors
    /// 123 for a variable without a link, 125 if a device does not respond.
    fn read_bits(&mut self, ports: &[Option<u32>]) -> Result<f64>;

    /// Sets digital outputs to the bits of a number and returns the number that the outputs can represent (`dioSet`).
    ///
    /// # Errors
    /// As for [`write_digital`](Self::write_digital), for any output; in this case no output is set.
    fn write_bits(&mut self, ports: &[Option<u32>], value: f64) -> Result<f64>;

    /// Reads an analog input or output.
    ///
    /// # Errors
    /// 123 without a link, 125 if the device does not respond.
    fn read_analog(&mut self, port: Option<u32>) -> Result<f64>;

    /// Sets an analog output and returns the resulting value.
    ///
    /// # Errors
    /// 122 for an input, 123 without a link, 124 for an output of the system, 125 if the device does not respond.
    fn write_analog(&mut self, port: Option<u32>, value: f64) -> Result<f64>;

    /// Returns the result of `ioStatus`, -3 to 2. `base` is the variable's type.
    fn io_status(&mut self, base: BaseType, port: Option<u32>) -> i8;

    /// Returns the texts for `ioStatus`.
    fn io_texts(&mut self, port: Option<u32>) -> IoDescription;

    /// Returns a text for each failed field bus device, `number:device\module` (`ioBusStatus`).
    fn failed_devices(&mut self) -> Vec<Text>;
}
