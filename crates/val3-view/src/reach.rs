//! Message `reach`: points and joint positions that the last move's tool cannot reach.

use val3_machine::controller::Controller;

use crate::commands::{out_of_reach, tool_of_last_move};
use crate::positions::GlobalValue;
use crate::wire::ReachMessage;

/// Last message, from which changes are found.
#[derive(Debug, Default)]
pub(crate) struct ReachState(Option<ReachMessage>);

impl ReachState {
    /// Returns the message if it differs from the last one. It is computed if a position (`has_changed`) or the number
    /// of the tool has changed. A change of the arm's configuration alone, on which points with `ssame` depend, does not
    /// repeat the computation.
    pub(crate) fn changes(
        &mut self,
        t: f64,
        tool: u8,
        has_changed: bool,
        data: &[GlobalValue],
        controller: &Controller,
    ) -> Option<ReachMessage> {
        let Self(last) = self;
        if !has_changed && last.as_ref().is_some_and(|last| last.tool == tool) {
            return None;
        }
        let unreachable = out_of_reach(&tool_of_last_move(controller), data, controller);
        if last.as_ref().is_some_and(|last| (last.tool, &last.unreachable) == (tool, &unreachable)) {
            return None;
        }
        *last = Some(ReachMessage { t, tool, unreachable });
        last.clone()
    }
}
