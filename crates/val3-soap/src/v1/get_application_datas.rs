//! `getApplicationDatas`: an application's data with the current values.

use crate::base64_value::Binary;
use crate::structure::{operation, structure};

structure! {
    /// Request `getApplicationDatas`.
    GetApplicationDatas {
        /// Project, for example `Disk://name/name.pjx`.
        name: Option<String> = "name",
    }
}

structure! {
    /// Answer of `getApplicationDatas`.
    GetApplicationDatasAnswer {
        /// Data file of the project (`.dtx`).
        data: Binary = "data",
    }
}

operation!(GetApplicationDatas: V1 "getApplicationDatas" => GetApplicationDatasAnswer, "getApplicationDatasResponse");
