//! `setProjectAsModified`: marks a project as changed.

use crate::structure::{operation, structure};
use crate::value::Empty;

structure! {
    /// Request `setProjectAsModified`.
    SetProjectAsModified {
        /// Name of the project.
        project: Option<String> = "prjName",
    }
}

operation!(SetProjectAsModified: V2 "setProjectAsModified" => Empty, "setProjectAsModifiedResponse");
