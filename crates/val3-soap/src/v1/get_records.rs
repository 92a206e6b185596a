//! `getRecords`: names of recordings.

use crate::structure::{operation, structure};

structure! {
    /// Request `getRecords`.
    GetRecords {}
}

structure! {
    /// Answer of `getRecords`.
    GetRecordsAnswer {
        /// Names.
        records: Vec<String> = "records" of "record",
    }
}

operation!(GetRecords: V1 "getRecords" => GetRecordsAnswer, "getRecordsResponse");
