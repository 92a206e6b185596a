//! Server `/CS8ServerV3`: kinematics, motion, power.

mod configuration;
mod description;
mod forward_kin;
mod matrix;
mod move_c;
mod move_jc;
mod move_jj;
mod move_l;
mod reset_motion;
mod restart_motion;
mod results;
mod reverse_kin;
mod scheduler_refresh;
mod set_power;
mod set_scheduling_mode;
mod stop_motion;

pub use configuration::{AboveBelow, AnthroConfig, ArmConfig, PositiveNegative, ScaraConfig, Shoulder, VrbxConfig};
pub use description::{BlendType, MotionDescription, MoveType};
pub use forward_kin::{ForwardKin, ForwardKinAnswer};
pub use matrix::Matrix;
pub use move_c::MoveC;
pub use move_jc::MoveJc;
pub use move_jj::MoveJj;
pub use move_l::MoveL;
pub use reset_motion::ResetMotion;
pub use restart_motion::RestartMotion;
pub use results::{
    MotionAnswer, MotionResult, MoveAnswer, PowerResult, ReversingResult, RobotPosition, SchedulingMode,
};
pub use reverse_kin::{ReverseKin, ReverseKinAnswer};
pub use scheduler_refresh::{SchedulerRefresh, SchedulerRefreshAnswer};
pub use set_power::{SetPower, SetPowerAnswer};
pub use set_scheduling_mode::SetSchedulingMode;
pub use stop_motion::StopMotion;
