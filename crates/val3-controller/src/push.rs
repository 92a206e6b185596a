//! Push: local changes are uploaded in one pass, after a backup, and are verified or undone.
//!
//! The journal next to the backup is written before the controller is changed. If the process is killed, the next
//! command reads it, and restores the old files or finds that all new ones are in place.

mod file_steps;
mod journal;
mod load_order;
mod lock;
mod new_tree;
mod plan;
mod recovery;
mod removals;
mod transfer;

pub use self::lock::LockOwner;
pub use self::new_tree::{WrittenTree, affected_projects};
pub use self::plan::{PlannedChange, PushPlan};
pub use self::recovery::{RecoveredPush, RecoveryOutcome, recover};
pub use self::transfer::{FailureOutcome, PushFailure, PushRequest, push};
