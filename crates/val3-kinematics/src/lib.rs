//! Arm models: geometry, limits, forward and inverse kinematics, configurations (manual 9.7, 11.4).
//!
//! The world frame has its origin on axis 1 of a six-axis arm at the height of axis 2, and z up. With all joints at 0
//! the arm is stretched upwards. A SCARA arm has two parallel axes, a vertical stroke and a flange whose z axis points
//! down.
//!
//! ```
//! use val3_kinematics::{Arm, RequestedConfiguration};
//!
//! let arm = Arm::by_name("TX2-90").expect("a shipped arm");
//! let joints = [0.0, 30.0, 60.0, 0.0, 90.0, 0.0];
//! let flange = arm.forward(&joints);
//!
//! let found = arm.solve(&flange, &joints, RequestedConfiguration::SAME).expect("the arm has just been there");
//! for (found, expected) in found.iter().zip(joints) {
//!     assert!((found - expected).abs() < 1e-9);
//! }
//! ```

mod arm;
mod calibration;
mod configuration;
mod data;
mod dh;
mod excess_speed;
mod files;
mod inverse;
mod jacobian;
mod library;
mod scara;
mod shapes;
mod six_axis;
mod times;
mod turns;
mod unreachable;

pub use self::arm::{Arm, AxisLimits, Payload, Violation};
pub use self::configuration::{Configuration, ConfigurationRequest, Elbow, RequestedConfiguration, Shoulder, Wrist};
pub use self::data::ArmError;
pub use self::dh::{Dh, DhError};
pub use self::excess_speed::ExcessSpeed;
pub use self::jacobian::Twist;
pub use self::library::{DEFAULT_SCARA, DEFAULT_SIX_AXIS, UnknownArm};
pub use self::shapes::LinkCapsule;
pub use self::unreachable::Unreachable;

/// Joint position in degrees. Axis 3 of a SCARA arm is in mm, and its last two entries are 0.
pub type Joints = [f64; 6];
