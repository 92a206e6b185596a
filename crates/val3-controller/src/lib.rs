//! Controller files, by FTP with or without TLS, or in an emulator's folder: pull, comparison, and a push after which the
//! controller has the old application or the new application.
//!
//! [`ControllerFiles`] are the operations of a controller; [`FtpFiles`] and [`FolderFiles`] implement them. A
//! [`ControllerProject`] remembers the controller and its files at the last pull, with which [`compare()`] compares both
//! sides by content. A [`PushPlan`] is plain data; [`push()`] executes it with a journal, from which [`recover`] undoes it.
//! Time, user and password are arguments.

mod access;
mod address;
mod certificate;
mod compare;
mod connection_settings;
mod digest;
mod error;
mod folder;
mod ftp;
mod identity;
mod identity_files;
mod observer;
mod path;
mod project;
mod pull;
mod push;
mod rules;
mod running;
mod scan;
mod server_address;
mod status;

pub use access::{AccessError, AccessFault, ControllerFiles, ListedEntry};
pub use address::{AddressFault, ControllerAddress, FtpAddress};
pub use certificate::{CertificateFingerprint, FingerprintFault};
pub use compare::{FileDifference, FileDifferences, SideChange, compare};
pub use connection_settings::{ConnectionSettings, FtpTimeouts};
pub use digest::{FileDigest, FileDigests};
pub use error::ControllerError;
pub use folder::FolderFiles;
pub use ftp::{FtpFiles, Password};
pub use identity::ControllerIdentity;
pub use observer::{SilentObserver, TransferObserver, TransferStep};
pub use path::{ControllerPath, NameFault, NameFaultKind};
pub use project::{ControllerProject, ProjectState};
pub use pull::{ConflictVersions, MergeConflict, PullDecisions, PullRequest, PullResult, pull};
pub use push::{
    FailureOutcome, LockOwner, PlannedChange, PushFailure, PushPlan, PushRequest, RecoveredPush, RecoveryOutcome,
    WrittenTree, affected_projects, push, recover,
};
pub use rules::{LOG_FOLDER, is_protected};
pub use scan::{
    ReadableFiles, TOTAL_LIMIT, check_applications, files_below, read_file, read_files, read_readable_files,
};
pub use server_address::ServerAddress;
pub use status::{ProjectStatus, check_identity};
