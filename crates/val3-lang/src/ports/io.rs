//! Inputs, outputs and serial lines (3.5 to 3.7). A variable holds the number of its link (`Link::Port`).

use crate::fault::Result;
use crate::types::BaseType;
use crate::values::Text;

/// Details that `ioStatus` returns besides the status.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct IoDescription {
    /// The free text of its configuration; empty where the link leads nowhere.
    pub description: Text,
    /// The target of the variable's link.
    pub path: Text,
}

/// Inputs, outputs and serial lines of the controller.
pub trait IoPort {
    /// The state of a digital input or output.
    ///
    /// # Errors
    /// 123 without a link, 125 if the device does not answer.
    fn read_digital(&mut self, port: Option<u32>) -> Result<bool>;

    /// Sets a digital output.
    ///
    /// # Errors
    /// 122 for an input, 123 without a link, 124 for an output of the system, 125 if the device does not answer.
    fn write_digital(&mut self, port: Option<u32>, value: bool) -> Result<()>;

    /// Digital inputs or outputs as a binary number, the first one the lowest bit (`dioGet`).
    ///
    /// # Errors
    /// 123 if one has no link, 125 if the device of one does not answer.
    fn read_bits(&mut self, ports: &[Option<u32>]) -> Result<f64>;

    /// Sets digital outputs to the bits of a number, and gives the number that they show then (`dioSet`).
    ///
    /// # Errors
    /// As [`write_digital`](Self::write_digital) for any of them; then none is set.
    fn write_bits(&mut self, ports: &[Option<u32>], value: f64) -> Result<f64>;

    /// The value of an analog input or output.
    ///
    /// # Errors
    /// 123 without a link, 125 if the device does not answer.
    fn read_analog(&mut self, port: Option<u32>) -> Result<f64>;

    /// Sets an analog output and gives the value that it really has then.
    ///
    /// # Errors
    /// 122 for an input, 123 without a link, 124 for an output of the system, 125 if the device does not answer.
    fn write_analog(&mut self, port: Option<u32>, value: f64) -> Result<f64>;

    /// Whether an input or output works: the result of `ioStatus`, -3 to 2. `base` is the type of the variable.
    fn io_status(&mut self, base: BaseType, port: Option<u32>) -> i8;

    /// The texts that `ioStatus` gives.
    fn io_texts(&mut self, port: Option<u32>) -> IoDescription;

    /// A text for each field bus device that has failed, `number:device\module` (`ioBusStatus`).
    fn failed_devices(&mut self) -> Vec<Text>;
}
