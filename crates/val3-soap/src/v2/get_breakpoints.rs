//! `getBreakpoints`: the breakpoints that are set.

use super::LineReference;
use crate::structure::{operation, structure};

structure! {
    /// Request `getBreakpoints`.
    GetBreakpoints {}
}

structure! {
    /// Answer of `getBreakpoints`.
    GetBreakpointsAnswer {
        /// Lines.
        breakpoints: Vec<LineReference> = "breakpoints" of "BreakPoint",
    }
}

operation!(GetBreakpoints: V2 "getBreakpoints" => GetBreakpointsAnswer, "getBreakpointsResponse");
