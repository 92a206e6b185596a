//! Execution of fragments between two operations of the run.

use std::sync::atomic::Ordering::Relaxed;

use val3_bytecode::Fragment;
use val3_lang::call::Argument;
use val3_lang::memory::Memory;
use val3_vm::{FragmentContext, FragmentEnd};

use super::Controller;
use crate::devices::Devices;
use crate::event::Event;

impl Controller {
    /// Executes the granted number of a fragment's lines, while tasks, clock and arm do not advance. `look` receives an
    /// expression's value. The events belong to the fragment; the run's own events are kept.
    pub fn evaluate<T>(
        &mut self,
        fragment: &Fragment,
        context: FragmentContext,
        grants: &mut dyn Iterator<Item = u32>,
        look: impl FnOnce(&mut Memory, &Devices, Argument) -> T,
    ) -> (FragmentEnd<T>, Vec<Event>) {
        let now = self.schedule.now;
        // An interrupt before this has stopped the run.
        let interrupted = self.devices.interrupt.swap(false, Relaxed);
        let aside = self.devices.set_record_aside();
        let end = self.vm.evaluate(fragment, context, grants, now, &mut self.devices, look);
        let events = self.devices.take_events();
        self.devices.resume_record(aside);
        self.devices.interrupt.fetch_or(interrupted, Relaxed);
        (end, events)
    }
}
