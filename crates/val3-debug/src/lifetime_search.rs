//! Search for the beginnings of watched local variables in the past.
//!
//! A call has no number: the frames of two calls of a program by the same line are equal. Before the run goes back to a
//! snapshot, the history is therefore replayed from there to the first moment at which the watched call is known, to
//! find out whether the frame has existed since then, or when it was created.

use std::sync::Arc;

use val3_vm::{CycleWatch, DataWatch, WatchedValue};

use crate::debugger::Debugger;
use crate::history::Moment;
use crate::lifetimes::Beginning;
use crate::watched::WatchedData;

impl Debugger {
    /// Determines which lifetimes contain the moments from `target` on, before the run goes back to this moment. The run
    /// is then at any moment.
    pub(crate) fn trace_lifetimes(&mut self, target: Moment) {
        let mut watches = std::mem::take(&mut self.data);
        for (data, life) in watches.lifetimes() {
            while let Beginning::Before(known) = life.beginning
                && target < known
                && let Some(beginning) = self.earlier_beginning(data, known)
            {
                life.beginning = beginning;
            }
        }
        self.data = watches;
    }

    /// Returns the beginning of a variable that exists at the moment `known`, as far as the last snapshot before it
    /// shows. `None` if there is no such snapshot.
    fn earlier_beginning(&mut self, data: &WatchedData, known: Moment) -> Option<Beginning> {
        let point = self.history.as_ref()?.earlier(known)?;
        let start = point.moment;
        self.controller.restore(&point.snapshot);
        let mut has_frame = data.has_frame(&self.controller);
        let is_first = data.owner().is_some_and(|owner| owner.index == 0);
        if is_first && has_frame {
            // A task has its number and its first frame only once.
            return Some(Beginning::Before(start));
        }
        let mut begun = None;
        self.watch_frame(data, has_frame);
        // Another task creates the first frame of a task, in one of its lines.
        let watch = if is_first { CycleWatch::Lines } else { CycleWatch::Changes };
        while self.replay(watch, known).is_some() {
            let had_frame = std::mem::replace(&mut has_frame, data.has_frame(&self.controller));
            if had_frame != has_frame {
                self.watch_frame(data, has_frame);
                begun = has_frame.then(|| Moment::of(&self.controller)).or(begun);
            }
        }
        // A change by the caller at the end of this part is not repeated by a replay.
        let begun = if has_frame { begun } else { Some(known) };
        Some(begun.map_or(Beginning::Before(start), Beginning::At))
    }

    /// Lets turns end when the frame of a local variable is removed or created.
    fn watch_frame(&mut self, data: &WatchedData, has_frame: bool) {
        let mut watch = DataWatch::default();
        match data.owner() {
            Some(owner) if has_frame => watch.values.push(WatchedValue::frame(owner)),
            owner => watch.awaited.extend(owner),
        }
        self.controller.vm.watch_data(Some(Arc::new(watch)));
    }
}
