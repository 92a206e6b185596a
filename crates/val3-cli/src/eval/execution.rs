//! The execution of a text: its program runs to its end on the controller of the scope.

use std::sync::Arc;

use val3_bytecode::Image;
use val3_lang::ports::TaskNumber;
use val3_machine::controller::{Controller, Outcome};
use val3_vm::TaskState;

use super::answer::Answer;
use super::interrupt::Interrupt;
use super::sources::NAME;
use crate::application::Pace;
use crate::user_error::UserError;

/// Who hears what comes of a text, as it comes.
pub(super) type Listener<'a> = dyn FnMut(&Answer) -> Result<(), UserError> + 'a;

/// A controller in memory, with what its texts have left.
pub(super) struct Execution {
    controller: Controller,
    pace: Pace,
    /// Ctrl-C ends a text.
    pub(super) interrupt: Interrupt,
}

impl Execution {
    pub(super) fn new(mut controller: Controller) -> Self {
        let interrupt = Interrupt::default();
        controller.devices.interrupt = interrupt.flag();
        Self { controller, pace: Pace::default(), interrupt }
    }

    /// Replaces the image: new data begin with their first values, and data that the image lacks are removed.
    ///
    /// # Errors
    /// The controller has no memory for it; its image is then unchanged.
    pub(super) fn exchange(&mut self, image: Arc<Image>) -> Result<(), &'static str> {
        self.controller.exchange(image).map_err(|_| "the controller has not enough memory (run-time error 40)")
    }

    /// Executes the program of a text until its task has ended. Other tasks go on meanwhile, and with the next text.
    ///
    /// # Errors
    /// The listener cannot listen.
    pub(super) fn run(&mut self, image: Arc<Image>, is_string: bool, tell: &mut Listener<'_>) -> Result<(), UserError> {
        if let Err(fault) = self.exchange(image) {
            return tell(&Answer::Fault(fault.to_owned().into()));
        }
        self.interrupt.take();
        let Ok(task) = self.controller.start(NAME) else {
            return tell(&Answer::Fault("the text cannot be started".to_owned().into()));
        };
        loop {
            let step = self.controller.step_tasks();
            for answer in self.controller.devices.take_events().iter().filter_map(|event| Answer::of(event, is_string))
            {
                tell(&answer)?;
            }
            if let Some(end) = self.end(task, step) {
                self.controller.kill(task);
                self.controller.devices.take_events();
                return end.map_or(Ok(()), |fault| tell(&Answer::Fault(fault.to_owned().into())));
            }
        }
    }

    /// Whether the text has ended, with what has kept it from its own end; else lets the time pass until something can
    /// happen.
    fn end(&mut self, task: TaskNumber, step: Outcome) -> Option<Option<&'static str>> {
        let state = self.controller.vm.tasks().iter().find(|known| known.id == task).map(|task| task.state);
        let goes_on = match (state, step) {
            (None | Some(TaskState::Failed(_)), _) => return Some(None),
            _ if self.interrupt.take() => return Some(Some("interrupted")),
            (_, Outcome::Lacking) => {
                self.controller.kill_tasks();
                return Some(None);
            }
            (_, Outcome::Waiting(wake)) => self.pace.wait(&mut self.controller, wake),
            (_, outcome) if outcome.is_final() => false,
            _ => {
                self.pace.follow(&self.controller);
                true
            }
        };
        (!goes_on).then_some(Some("it waits for what cannot happen here"))
    }
}
