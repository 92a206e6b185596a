//! Values of the simple types, and the functions of their instructions (3.1 to 3.4, 4.3).
//!
//! Plain functions of plain values: no machine, no clock, no allocation. A value that an instruction does not accept
//! results in the number of a run-time error. Numbers are IEEE doubles; the functions that the hardware or the system's
//! library would compute differently from machine to machine come from `libm`.

pub mod binary;
pub mod bits;
mod config;
pub mod date;
mod mdesc;
pub mod number_reading;
pub mod number_text;
pub mod numbers;
pub mod printed;
pub mod strings;
pub mod text;

pub use config::ConfigValue;
pub use mdesc::{HIGHEST_AXIS_SPEED, MdescValue};
pub use text::Text;
