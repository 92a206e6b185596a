//! State that the readers of a feed know, from which changes are found.

use crate::motion::MotionKey;
use crate::reach::ReachState;
use crate::signals::SignalStates;
use crate::wire::{CellPoint, JointValue, MotionMessage, PageMessage, PartsMessage, StateMessage};

/// Last messages. By default, the readers know nothing.
#[derive(Debug, Default)]
pub(super) struct Known {
    pub(super) state: Option<StateMessage>,
    pub(super) motion: Option<(MotionKey, MotionMessage)>,
    pub(super) page: Option<PageMessage>,
    pub(super) parts: Option<PartsMessage>,
    pub(super) points: Vec<CellPoint>,
    pub(super) joints: Vec<JointValue>,
    pub(super) frames: Vec<CellPoint>,
    pub(super) cell_tools: Vec<CellPoint>,
    pub(super) reach: ReachState,
    pub(super) signals: SignalStates,
}
