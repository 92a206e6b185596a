//! References to a library's data (2.6), which prevent it from being unloaded (6.6).

use val3_bytecode::Storage;
use val3_lang::memory::{Stack, StoreId};

use crate::task::Thread;
use crate::turn_context::TurnContext;
use crate::{Frame, InstanceId, Rate};

impl TurnContext<'_> {
    /// Whether a program on some task's stack received the library's data by reference, or a synchronous task reports
    /// its overruns there. The stack of the running task is currently in the memory.
    pub(crate) fn is_referred_to(&self, running: &Thread, library: InstanceId) -> bool {
        let others = self.roster.tasks.iter().map(|task| (&*task.thread, &task.thread.stack));
        let mut threads = others.chain([(running, &self.space.memory.stack)]);
        let is_data = |store: StoreId| self.space.memory.project(store) == Some(library.0);
        let mut overruns = self.roster.tasks.iter().filter_map(|task| match task.rate {
            Rate::Period { overrun, .. } => Some(overrun.store),
            Rate::Priority(_) => None,
        });
        overruns.any(is_data)
            || threads.any(|(thread, stack)| {
                thread.frames.iter().flat_map(|frame| self.references(frame, stack)).any(is_data)
            })
    }

    /// Returns the containers to which the parameters of a program refer.
    fn references(&self, frame: &Frame, stack: &Stack) -> Vec<StoreId> {
        let instance = self.space.instance(frame.instance);
        let program = instance.and_then(|instance| instance.image.programs.get(usize::from(frame.program)));
        let params = program.map(|program| program.params.as_slice()).unwrap_or_default();
        let found = params.iter().filter_map(|param| match param.storage {
            Storage::Place(number) => {
                stack.places.get(frame.base.place as usize + usize::from(number)).map(|at| at.store)
            }
            Storage::View(number) => {
                stack.views.get(frame.base.view as usize + usize::from(number)).map(|view| view.store)
            }
            Storage::Value(_) | Storage::Part(_) => None,
        });
        found.collect()
    }
}
