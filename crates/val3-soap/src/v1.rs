//! Server `/CS8ServerV1`: applications, data, recordings, limits of joints.

mod get_application_datas;
mod get_applications;
mod get_joint_range;
mod get_record;
mod get_records;
mod types;

pub use get_application_datas::{GetApplicationDatas, GetApplicationDatasAnswer};
pub use get_applications::{GetApplications, GetApplicationsAnswer};
pub use get_joint_range::{GetJointRange, GetJointRangeAnswer};
pub use get_record::{GetRecord, GetRecordAnswer};
pub use get_records::{GetRecords, GetRecordsAnswer};
pub use types::{JointRange, ListedApplication};
