//! `getProject`: the files of a project.

use crate::base64_value::Binary;
use crate::structure::{operation, structure};

structure! {
    /// Request `getProject`.
    GetProject {
        /// Project, for example `Disk://name/name.pjx`.
        name: Option<String> = "name",
    }
}

structure! {
    /// Answer of `getProject`.
    GetProjectAnswer {
        /// Archive of the project.
        data: Binary = "data",
    }
}

operation!(GetProject: V2 "getProject" => GetProjectAnswer, "getProjectResponse");
