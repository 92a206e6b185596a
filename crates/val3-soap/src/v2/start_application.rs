//! `startApplication`: starts an application. Known from a newer client only; the spelling is inferred.

use crate::structure::{operation, structure};
use crate::value::Empty;

structure! {
    /// Request `startApplication`.
    StartApplication {
        /// Project, for example `Disk://name/name.pjx`.
        path: Option<String> = "applicationPath",
    }
}

operation!(StartApplication: V2 "startApplication" => Empty, "startApplicationResponse");
