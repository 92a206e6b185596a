//! Inputs, outputs and serial lines (3.5 to 3.7). A variable holds the number of its link (`Link::Port`).

use crate::fault::Result;

/// Inputs, outputs and serial lines of the controller.
pub trait Io {
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
}
