//! Values of the simple types, and the functions of their instructions (3.1 to 3.4, 4.3).
//!
//! Plain functions without access to the machine or a clock, and without allocation. For an invalid value, they return
//! the number of a run-time error. Numbers are IEEE doubles; functions whose results depend on the hardware or the
//! system library come from `libm`.

pub mod binary;
pub mod bits;
mod config;
pub mod date;
mod joint;
mod mdesc;
pub mod number_reading;
pub mod number_text;
pub mod numbers;
pub mod printed;
pub mod strings;
pub mod text;

pub use config::ConfigValue;
pub use joint::JointValue;
pub use mdesc::{HIGHEST_AXIS_SPEED, MdescValue};
pub use text::Text;
