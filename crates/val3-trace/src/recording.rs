//! Recording of a run's motion, with the instructions that requested it.

use std::collections::BTreeMap;

use val3_lang::ports::Time;
use val3_machine::controller::{CodeSource, Controller};
use val3_vm::CYCLE;

use crate::row::{Trace, TraceRow};
use crate::selection::RowSelection;

/// Recorded motion of a run.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct MotionRecording {
    /// Trace with a row for each cycle.
    pub trace: Trace,
    /// Moves, with their first rows.
    moves: Vec<MoveStart>,
}

#[derive(Debug, Clone, PartialEq)]
struct MoveStart {
    row: usize,
    source: Option<CodeSource>,
}

/// Records the motion of a controller.
#[derive(Debug)]
pub struct MotionRecorder {
    recording: MotionRecording,
    selection: RowSelection,
    /// Instructions of moves, by the integer part of the id.
    sources: BTreeMap<i64, CodeSource>,
    /// Motion revision for which the instructions are known.
    revision: Option<u64>,
    /// Start time of the last cycle.
    last: Option<Time>,
}

impl MotionRecorder {
    /// Creates a recorder for a controller whose arm has not moved yet.
    #[must_use]
    pub fn new(controller: &Controller) -> Self {
        let arm = controller.arm().model();
        let trace = Trace { arm: Some(arm.name().to_owned()), axes: arm.axes(), rows: Vec::new() };
        let recording = MotionRecording { trace, moves: Vec::new() };
        Self { recording, selection: RowSelection::default(), sources: BTreeMap::new(), revision: None, last: None }
    }

    /// Adds the cycle that began at `start`.
    pub fn see(&mut self, start: Time, controller: &Controller) {
        if self.last.is_some_and(|last| start < last + CYCLE) {
            return;
        }
        self.last = Some(start);
        let revision = controller.arm().motion().revision();
        if self.revision.replace(revision) != Some(revision) {
            let sourced = controller.motion_queue().into_iter();
            self.sources.extend(sourced.filter_map(|queued| Some((queued.id.floor() as i64, queued.source?))));
        }
        let sample = controller.arm().sample();
        if self.selection.takes(sample.phase) {
            self.record(TraceRow::new(start, sample));
        }
    }

    fn record(&mut self, row: TraceRow) {
        let MotionRecording { trace, moves } = &mut self.recording;
        if trace.rows.last().is_none_or(|last| last.number() != row.number()) {
            moves.push(MoveStart { row: trace.rows.len(), source: self.sources.get(&row.number()).cloned() });
        }
        trace.rows.push(row);
    }

    /// Returns the motion recorded so far.
    #[must_use]
    pub fn recording(&self) -> &MotionRecording {
        &self.recording
    }

    /// Returns the recorded motion.
    #[must_use]
    pub fn finish(self) -> MotionRecording {
        self.recording
    }
}

impl MotionRecording {
    /// Creates a recording whose moves have instructions by move number.
    #[cfg(test)]
    pub(crate) fn with_sources(trace: Trace, source: impl Fn(i64) -> CodeSource) -> Self {
        let stretches = crate::stretch::stretches(&trace.rows).into_iter();
        let starts =
            stretches.map(|stretch| MoveStart { row: stretch.rows.start, source: Some(source(stretch.number)) });
        Self { moves: starts.collect(), trace }
    }

    /// Returns the present position of the arm, for a run in which it has not moved.
    #[must_use]
    pub fn at_rest(controller: &Controller) -> Self {
        let mut recorder = MotionRecorder::new(controller);
        recorder.record(TraceRow::new(controller.now(), controller.arm().sample()));
        recorder.finish()
    }

    /// Whether the arm has not moved.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.trace.rows.is_empty()
    }

    /// Returns the instruction of the move that contains a row.
    #[must_use]
    pub fn source(&self, row: usize) -> Option<&CodeSource> {
        let after = self.moves.partition_point(|start| start.row <= row);
        self.moves.get(after.checked_sub(1)?)?.source.as_ref()
    }
}
