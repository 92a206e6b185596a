//! `getRecord`: a recording.

use crate::base64_value::Binary;
use crate::structure::{operation, structure};

structure! {
    /// Request `getRecord`.
    GetRecord {
        /// Name of the recording.
        name: Option<String> = "name",
    }
}

structure! {
    /// Answer of `getRecord`.
    GetRecordAnswer {
        /// Recording, in an unknown format.
        data: Binary = "data",
    }
}

operation!(GetRecord: V1 "getRecord" => GetRecordAnswer, "getRecordResponse");
