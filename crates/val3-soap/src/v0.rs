//! Server `/`: sessions, versions, arms, positions.

mod arms;
mod find_server;
mod get_controller_parameters;
mod get_cs8_compatibility;
mod get_cs8_versions;
mod get_robot_jnt_cart_pos;
mod get_robot_joint_pos;
mod get_robots;
mod get_soap_server_version;
mod login;
mod logout;
mod ping;
mod positions;
mod set_robot_joint_pos;
mod versions;

pub use arms::{DiameterAxis3, Kinematic, LengthAxis3, MountType, RobotDescription};
pub use find_server::{FindServer, FindServerAnswer};
pub use get_controller_parameters::{GetControllerParameters, GetControllerParametersAnswer};
pub use get_cs8_compatibility::{GetCs8Compatibility, GetCs8CompatibilityAnswer};
pub use get_cs8_versions::{GetCs8Versions, GetCs8VersionsAnswer};
pub use get_robot_jnt_cart_pos::{GetRobotJntCartPos, GetRobotJntCartPosAnswer};
pub use get_robot_joint_pos::{GetRobotJointPos, GetRobotJointPosAnswer};
pub use get_robots::{GetRobots, GetRobotsAnswer};
pub use get_soap_server_version::{GetSoapServerVersion, GetSoapServerVersionAnswer};
pub use login::{Login, LoginAnswer};
pub use logout::Logout;
pub use ping::{Ping, PingAnswer};
pub use positions::CartesianPosition;
pub use set_robot_joint_pos::SetRobotJointPos;
pub use versions::{ControllerParameter, InterfaceVersion, SoftwareVersion};
