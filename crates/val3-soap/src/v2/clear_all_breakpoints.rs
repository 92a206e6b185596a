//! `clearAllBreakpoints`: removes all breakpoints.

use crate::structure::{operation, structure};
use crate::value::Empty;

structure! {
    /// Request `clearAllBreakpoints`.
    ClearAllBreakpoints {}
}

operation!(ClearAllBreakpoints: V2 "clearAllBreakpoints" => Empty, "clearAllBreakpointsResponse");
