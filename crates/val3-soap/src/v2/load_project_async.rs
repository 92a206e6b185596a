//! `loadProjectAsync`: loads an application. Known from a newer client only; the spelling is inferred.

use crate::structure::{operation, structure};
use crate::value::Empty;

structure! {
    /// Request `loadProjectAsync`.
    LoadProjectAsync {
        /// Project, for example `Disk://name/name.pjx`.
        path: Option<String> = "applicationPath",
    }
}

operation!(LoadProjectAsync: V2 "loadProjectAsync" => Empty, "loadProjectAsyncResponse");
