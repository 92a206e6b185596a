//! The run of a session.

use val3_debug::Debugger;
use val3_session::FrameEvaluator;

/// The run that a session debugs.
pub struct Target<'a> {
    /// Its controller under control.
    pub debugger: &'a mut Debugger,
    /// Evaluates code in its frames.
    pub evaluator: &'a mut FrameEvaluator,
}
