//! `getWatches`: the values of data.

use super::{MimeData, WatchedData};
use crate::structure::{operation, structure};

structure! {
    /// Request `getWatches`.
    GetWatches {
        /// Data.
        watches: Vec<WatchedData> = "watch" of "SoapData",
    }
}

structure! {
    /// Answer of `getWatches`.
    GetWatchesAnswer {
        /// Values.
        data: MimeData = "data",
    }
}

operation!(GetWatches: V2 "getWatches" => GetWatchesAnswer, "getWatchResponse");
