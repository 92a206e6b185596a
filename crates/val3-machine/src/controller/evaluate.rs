//! Execution of fragments between two operations of the run.

use std::sync::atomic::Ordering::Relaxed;

use val3_bytecode::Fragment;
use val3_lang::call::Argument;
use val3_lang::memory::Memory;
use val3_lang::ports::{TaskNumber, Time};
use val3_vm::{FragmentContext, FragmentEnd, Vm};

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
        self.with_own_record(|vm, devices, now| vm.evaluate(fragment, context, grants, now, devices, look))
    }

    /// Executes statements like [`evaluate`](Self::evaluate), up to a stop mark in a called program: see
    /// [`Vm::execute`].
    pub fn execute_fragment(
        &mut self,
        fragment: &Fragment,
        task: TaskNumber,
        depth: usize,
        grants: &mut dyn Iterator<Item = u32>,
    ) -> (FragmentEnd<()>, Vec<Event>) {
        self.with_own_record(|vm, devices, now| vm.execute(fragment, task, depth, grants, now, devices))
    }

    /// Continues the statements on the stack of a task like [`execute_fragment`](Self::execute_fragment).
    pub fn resume_fragment(
        &mut self,
        task: TaskNumber,
        grants: &mut dyn Iterator<Item = u32>,
    ) -> (FragmentEnd<()>, Vec<Event>) {
        self.with_own_record(|vm, devices, now| vm.resume(task, grants, now, devices))
    }

    /// Executes a fragment, and returns its end and its events.
    fn with_own_record<T>(
        &mut self,
        execute: impl FnOnce(&mut Vm, &mut Devices, Time) -> FragmentEnd<T>,
    ) -> (FragmentEnd<T>, Vec<Event>) {
        let now = self.schedule.now;
        // An interrupt before this has stopped the run.
        let interrupted = self.devices.interrupt.swap(false, Relaxed);
        let aside = self.devices.set_record_aside();
        let end = execute(&mut self.vm, &mut self.devices, now);
        let events = self.devices.take_events();
        self.devices.resume_record(aside);
        self.devices.interrupt.fetch_or(interrupted, Relaxed);
        (end, events)
    }
}
