//! `setSchedulingMode`: sets who schedules the moves.

use super::SchedulingMode;
use crate::structure::{operation, structure};
use crate::value::Empty;

structure! {
    /// Request `setSchedulingMode`.
    SetSchedulingMode {
        /// New mode.
        mode: SchedulingMode = "schedulingMode",
    }
}

operation!(SetSchedulingMode: V3 "setSchedulingMode" => Empty, "setSchedulingModeResponse");
