//! `getApplications`: the applications of the controller.

use super::ListedApplication;
use crate::structure::{operation, structure};

structure! {
    /// Request `getApplications`.
    GetApplications {}
}

structure! {
    /// Answer of `getApplications`.
    GetApplicationsAnswer {
        /// Applications.
        applications: Vec<ListedApplication> = "applications" of "application",
    }
}

operation!(GetApplications: V1 "getApplications" => GetApplicationsAnswer, "getApplicationsResponse");
