//! Lifetimes of watched local variables: from the call of their program to its end.

use crate::history::Moment;

/// Lifetime of a watched local variable.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Lifetime {
    pub(crate) beginning: Beginning,
    /// Moment at which the variable's program ended.
    over: Option<Moment>,
}

/// Beginning of a lifetime.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Beginning {
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

    /// Discards the records after a moment at which the run was changed.
    pub(crate) fn discard_future(&mut self, now: Moment) {
        if let Beginning::At(begun) = self.beginning
            && now < begun
        {
            self.beginning = Beginning::After(now);
        }
    }
}
