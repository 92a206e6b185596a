//! Lifetimes of watched local variables: from the call of their program to its end.
//!
//! A call has no number: the frames of two calls of a program by the same line are equal. Before the run goes back to a
//! snapshot, the history is therefore replayed from there to the first moment at which the watched call is known, to
//! find out whether the frame has existed since then, or when it was created.

use std::sync::Arc;

use val3_vm::{CycleWatch, DataWatch, WatchedValue};

use crate::debugger::Debugger;
use crate::history::Moment;
use crate::watched::WatchedData;

/// Lifetime of a watched local variable.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Lifetime {
    beginning: Beginning,
    /// Moment at which the variable's program ended.
    over: Option<Moment>,
}

/// Beginning of a lifetime.
#[derive(Debug, Clone, Copy)]
enum Beginning {
    /// At or before this moment.
    Before(Moment),
    /// At this moment.
    At(Moment),
    /// The run was changed at this moment, before the program was called. The next call counts.
    After(Moment),
}

impl Lifetime {
    /// Returns the lifetime of a variable that exists at a moment.
    pub(crate) const fn of_existing(now: Moment) -> Self {
        Self { beginning: Beginning::Before(now), over: None }
    }

    pub(crate) const fn is_over(&self) -> bool {
        self.over.is_some()
    }

    /// Whether the variable exists, if its stack frame does.
    fn contains(&self, now: Moment) -> bool {
        let (Beginning::Before(begun) | Beginning::At(begun)) = self.beginning else { return false };
        !self.is_over() && begun <= now
    }

    /// Adds the state of the variable's stack frame after a line. Returns whether the variable exists.
    pub(crate) fn follow(&mut self, has_frame: bool, now: Moment) -> bool {
        if let Beginning::After(changed) = self.beginning
            && changed <= now
            && has_frame
        {
            self.beginning = Beginning::At(now);
        }
        if !has_frame && self.contains(now) {
            self.over = Some(now);
        }
        self.contains(now)
    }

    /// Adapts the lifetime after the run has gone to another moment. Returns whether the variable exists.
    pub(crate) fn go_to(&mut self, has_frame: bool, now: Moment) -> bool {
        self.over = self.over.filter(|over| *over <= now);
        self.follow(has_frame, now)
    }

    /// Discards what is recorded after a moment, because the run was changed there.
    pub(crate) fn discard_future(&mut self, now: Moment) {
        if let Beginning::At(begun) = self.beginning
            && now < begun
        {
            self.beginning = Beginning::After(now);
        }
    }
}

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
