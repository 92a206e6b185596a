//! Who steers a run: nobody, the client that has launched it, or clients that attach to it.

use std::time::Duration;

use val3_dap::{DebugSession, Demand, Reception, Target};
use val3_debug::Stop;
use val3_lang::ports::Time;
use val3_machine::event::Event;

/// What the loop of a run asks and tells between two cycles. Without a debugger it runs on.
pub(super) trait Guide {
    /// Handles the requests that have arrived.
    fn attend(&mut self, _target: &mut Target<'_>) -> Demand {
        Demand::Run
    }

    /// Learns what has happened in a cycle that began at `start`.
    fn follow(&mut self, _start: Time, _events: &[Event], _target: &mut Target<'_>) {}

    /// The run has stopped by itself.
    fn stop(&mut self, _stop: &Stop, _target: &Target<'_>) {}

    /// Waits for this time, or until a request has arrived.
    fn wait(&mut self, time: Duration) {
        std::thread::sleep(time);
    }
}

/// A run without a debugger.
pub(super) struct Nobody;

impl Guide for Nobody {}

impl Guide for DebugSession {
    fn attend(&mut self, target: &mut Target<'_>) -> Demand {
        self.attend(target)
    }

    fn follow(&mut self, start: Time, events: &[Event], target: &mut Target<'_>) {
        self.report(events, target);
        self.see(start, target);
    }

    fn stop(&mut self, stop: &Stop, target: &Target<'_>) {
        self.stop(stop, target);
    }

    fn wait(&mut self, time: Duration) {
        self.wait(time);
    }
}

impl Guide for Reception {
    fn attend(&mut self, target: &mut Target<'_>) -> Demand {
        self.attend(target)
    }

    fn follow(&mut self, start: Time, events: &[Event], target: &mut Target<'_>) {
        self.report(events, target);
        self.see(start, target);
    }

    fn stop(&mut self, stop: &Stop, target: &Target<'_>) {
        self.stop(stop, target);
    }

    fn wait(&mut self, time: Duration) {
        self.wait(time);
    }
}
