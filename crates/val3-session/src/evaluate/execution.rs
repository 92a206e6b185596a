//! Execution of code: its program runs to its end on the evaluator's controller.

use std::ops::ControlFlow;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use std::sync::atomic::Ordering::Relaxed;

use val3_bytecode::Image;
use val3_lang::ports::TaskNumber;
use val3_machine::controller::{Controller, RunStatus};
use val3_vm::TaskState;

use super::answer::EvaluationOutput;
use super::page_text::PageText;
use super::sources::NAME;
use crate::pace::{Delay, Pace};

/// Interface to the caller.
pub trait Listener {
    /// Receives each output item immediately. `Break` ends the evaluation.
    fn answer(&mut self, answer: &EvaluationOutput) -> ControlFlow<()>;

    /// Waits in real time.
    fn wait(&mut self, delay: Delay);
}

/// A controller, with the data that earlier evaluations have changed.
pub(super) struct Execution {
    controller: Controller,
    pace: Pace,
    /// Set by the caller to interrupt an evaluation.
    pub(super) interrupt: Arc<AtomicBool>,
}

impl Execution {
    pub(super) fn new(mut controller: Controller) -> Self {
        let interrupt = Arc::<AtomicBool>::default();
        controller.devices.interrupt = Arc::clone(&interrupt);
        Self { controller, pace: Pace::default(), interrupt }
    }

    /// Replaces the image. New data receive their initial values, and data that the image does not contain are removed.
    ///
    /// # Errors
    /// If the controller's memory is insufficient; the image is then unchanged.
    pub(super) fn exchange(&mut self, image: Arc<Image>) -> Result<(), &'static str> {
        self.controller.exchange(image).map_err(|_| "the controller does not have enough memory (run-time error 40)")
    }

    /// Executes the program of the code until its task has ended. Other tasks run at the same time, and also during the
    /// next evaluation.
    pub(super) fn run(&mut self, image: Arc<Image>, is_string: bool, listener: &mut dyn Listener) {
        self.interrupt.store(false, Relaxed);
        let started =
            self.exchange(image).and_then(|()| self.controller.start(NAME).map_err(|_| "it cannot be started"));
        let fault = match started {
            Ok(task) => self.run_task(task, is_string, listener),
            Err(message) => Some(message.to_owned()),
        };
        if let Some(fault) = fault {
            // The evaluation has ended, so a `Break` of the listener has no effect.
            let _ = listener.answer(&EvaluationOutput::Fault(fault.into()));
        }
    }

    /// Runs until the task has ended. Returns the reason if it did not reach its end.
    fn run_task(&mut self, task: TaskNumber, is_string: bool, listener: &mut dyn Listener) -> Option<String> {
        let mut page = PageText::default();
        let end = loop {
            let status = self.controller.step_tasks();
            let events = self.controller.devices.take_events();
            let mut answers = events.iter().flat_map(|event| EvaluationOutput::all_of(event, is_string, &mut page));
            if answers.try_for_each(|answer| listener.answer(&answer)).is_break() {
                page.take();
                break None;
            }
            match self.next(task, status) {
                ControlFlow::Continue(delay) => listener.wait(delay),
                ControlFlow::Break(end) => break end,
            }
        };
        self.controller.kill(task);
        self.controller.devices.take_events();
        let rest = page.take().map(EvaluationOutput::Line);
        if rest.is_some_and(|line| listener.answer(&line).is_break()) { None } else { end }
    }

    /// Advances the time to the next possible event. `Break` if the evaluation has ended, with the reason if it did not
    /// reach its end.
    fn next(&mut self, task: TaskNumber, status: RunStatus) -> ControlFlow<Option<String>, Delay> {
        let state = self.controller.vm.tasks().iter().find(|known| known.id == task).map(|task| task.state);
        let delay = match (state, status) {
            (None | Some(TaskState::Failed(_)), _) => return ControlFlow::Break(None),
            _ if self.interrupt.swap(false, Relaxed) => return ControlFlow::Break(Some("interrupted".to_owned())),
            (_, RunStatus::Unsupported) => {
                self.controller.kill_tasks();
                return ControlFlow::Break(None);
            }
            (_, RunStatus::Waiting(wake)) => self.pace.wait(&mut self.controller, wake),
            (_, status) if status.is_final() => None,
            _ => Some(self.pace.follow(&self.controller)),
        };
        match delay {
            Some(delay) => ControlFlow::Continue(delay),
            None => ControlFlow::Break(Some(self.endless_wait(task))),
        }
    }

    /// Message about code that waits endlessly, with the waiting line.
    fn endless_wait(&self, task: TaskNumber) -> String {
        let positions = self.controller.vm.tasks().iter().zip(self.controller.task_positions());
        let Some((_, position)) = positions.into_iter().find(|(known, _)| known.id == task) else {
            return "it waits for an event that cannot happen here".to_owned();
        };
        let place = match position.program == NAME {
            // The code begins on the second line of its file.
            true => format!("line {}", position.line.saturating_sub(1)),
            false => format!("line {} of `{}`", position.line, position.program),
        };
        let awaited = position.activity.awaited().unwrap_or_else(|| "an event".to_owned());
        format!("{place} waits for {awaited}, and nothing here can end the wait")
    }
}
