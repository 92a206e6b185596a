//! `getAllPhysicalIos`: the signals of the controller.

use super::MimeData;
use crate::structure::{operation, structure};

structure! {
    /// Request `getAllPhysicalIos`.
    GetAllPhysicalIos {}
}

structure! {
    /// Answer of `getAllPhysicalIos`.
    GetAllPhysicalIosAnswer {
        /// List of the signals.
        data: MimeData = "data",
    }
}

operation!(GetAllPhysicalIos: V2 "getAllPhysicalIos" => GetAllPhysicalIosAnswer, "getAllPhysicalIosResponse");
