//! The run of a session.

use val3_debug::Debugger;
use val3_session::FrameEvaluator;
use val3_view::FileReader;

/// Run that a session debugs.
pub struct DebuggedRun<'a> {
    /// Debugger of the run, with the controller.
    pub debugger: &'a mut Debugger,
    /// Evaluator of code in stack frames.
    pub evaluator: &'a mut FrameEvaluator,
    /// Reader of program files, for the code of lines in messages to pages.
    pub files: FileReader,
}
