//! Valid argument values beyond the type: ranges of numbers and formats of strings.

mod ranges;
mod serial;
mod texts;

pub use ranges::{ArgumentRange, DIMENSION, OutOfRange, bits, counts_seconds, dimensions, power_base, range};
pub use serial::{SERIAL_PARAMETERS, SerialFault, SerialParameter, SerialValue};
pub use texts::{BINARY_FORMATS, DATE_KEYS, TextForm, bytes, text_form};
