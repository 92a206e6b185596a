//! `clearBreakpoints`: removes breakpoints.

use super::{BreakpointResponse, LineReference};
use crate::structure::{operation, structure};

structure! {
    /// Request `clearBreakpoints`.
    ClearBreakpoints {
        /// Lines.
        breakpoints: Vec<LineReference> = "breakpoints" of "BreakPoint",
    }
}

structure! {
    /// Answer of `clearBreakpoints`.
    ClearBreakpointsAnswer {
        /// Results, in the order of the request.
        responses: Vec<BreakpointResponse> = "out" of "BreakpointResponse",
    }
}

operation!(ClearBreakpoints: V2 "clearBreakpoints" => ClearBreakpointsAnswer, "clearBreakpointsResponse");
