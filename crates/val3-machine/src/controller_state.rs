//! State of the controller outside its programs: power, modes, safety, users, log, versions (4.3, chapter 8).

mod cs9;
mod date;
mod event_log;
mod languages;
mod power;
mod profiles;
mod robot;
mod severity;
mod versions;
mod working_mode;

pub use cs9::Cs9;
pub use date::Calendar;
pub use event_log::{EventLog, LogEntry};
pub use languages::Languages;
pub use power::{POWER_OFF_TIME, POWER_ON_TIME, Power};
pub use profiles::{Profile, ProfileChange, Profiles};
pub use robot::{EmergencyStop, PowerRequest, Robot, RobotEvent, SpeedChange};
pub use severity::MessageSeverity;
pub use versions::{ControllerVersions, Licence};
pub use working_mode::{Activity, WorkingMode};
