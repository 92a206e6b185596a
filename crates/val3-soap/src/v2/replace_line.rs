//! `replaceLine`: replaces a line of a program in memory.

use super::{ProgramLine, ReplacementResult};
use crate::structure::{operation, structure};

structure! {
    /// Request `replaceLine`.
    ReplaceLine {
        /// Replaced line.
        line: ProgramLine = "line",
        /// New code.
        new_line: Option<String> = "newLine",
    }
}

structure! {
    /// Answer of `replaceLine`.
    ReplaceLineAnswer {
        /// Result.
        code: ReplacementResult = "retCode",
        /// Error description.
        output: Option<String> = "strOut",
    }
}

operation!(ReplaceLine: V2 "replaceLine" => ReplaceLineAnswer, "replaceLineResponse");
