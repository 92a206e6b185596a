//! `setBreakpoints`: sets breakpoints.

use super::{BreakpointResponse, LineReference};
use crate::structure::{operation, structure};

structure! {
    /// Request `setBreakpoints`.
    SetBreakpoints {
        /// Lines.
        breakpoints: Vec<LineReference> = "breakpoints" of "BreakPoint",
    }
}

structure! {
    /// Answer of `setBreakpoints`.
    SetBreakpointsAnswer {
        /// Results, in the order of the request.
        responses: Vec<BreakpointResponse> = "out" of "BreakpointResponse",
    }
}

operation!(SetBreakpoints: V2 "setBreakpoints" => SetBreakpointsAnswer, "setBreakpointsResponse");
