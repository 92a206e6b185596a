//! Instructions: their arguments, their call, and their requests to the virtual machine.

use smallvec::SmallVec;
use val3_bytecode::{Handler, InstructionSite};
use val3_lang::call::{Argument, Call, Caller, Flow, Reach, Wait, Waiting};
use val3_lang::fault::Result;
use val3_lang::ports::{Time, nanoseconds};

use crate::execute::Leave;
use crate::operands::OperandContext;
use crate::services::{Services, TaskChanges};
use crate::task::Thread;
use crate::turn_context::TurnContext;
use crate::{Frame, TaskState, TurnEnd};

impl TurnContext<'_> {
    /// Executes an instruction; `Some` if the interpreter has to leave the program afterwards.
    pub(crate) fn instruction(
        &mut self,
        thread: &mut Thread,
        scope: OperandContext<'_>,
        frame: &Frame,
        line: u32,
        site: &InstructionSite,
    ) -> Result<Option<Leave>> {
        let now = self.now();
        self.ports.origin(self.origin(now, frame, line));
        let Some(Handler(run)) = site.run else {
            self.ports.lacking(site.callee.name());
            return Ok(Some(Leave::Turn(TurnEnd::Unsupported)));
        };
        let memory = &self.space.memory;
        let mut arguments = SmallVec::<[Argument; 4]>::new();
        for argument in &site.arguments {
            arguments.push(scope.argument(memory, argument)?);
        }
        let result = site.result.map(|(operand, _)| scope.place(memory, operand)).transpose()?;
        let image = &scope.instance.image;
        let mut services = Services {
            roster: self.roster,
            instances: &self.space.instances,
            changes: TaskChanges::new(),
            request: None,
            owner: frame.instance,
        };
        let reach = Reach { memory: &mut self.space.memory, ports: self.ports, tasks: &mut services };
        let caller = Caller { version: image.version, unit: image.unit, arm: image.arm };
        let mut call = Call::new(reach, caller, now, thread.waiting, &arguments, result);
        let flow = run(&mut call)?;
        self.reads_clock |= call.reads_clock;
        let Services { changes, request, .. } = services;
        changes.iter().for_each(|(task, name, change, at)| self.ports.task(*task, name, *change, *at));
        let is_stopped = !changes.is_empty() && self.is_stopped();
        if !changes.is_empty() {
            self.end_with_turn();
        }
        let leave = request.is_some().then_some(Leave::Elsewhere);
        if let Some(request) = request {
            let code = self.fulfil(thread, frame.instance, *request);
            result.map_or(Ok(()), |place| self.space.memory.set_num(place, 0, code))?;
        }
        match flow {
            Flow::Done(()) => thread.waiting = None,
            Flow::Wait(wait) => {
                thread.waiting = Some(Waiting::then(thread.waiting, wait, now));
                thread.wait = Some(wait);
                return Ok(Some(Leave::Turn(TurnEnd::Waiting(wait.wake))));
            }
        }
        let stop = if is_stopped { Some(TurnEnd::Halted) } else { self.pause(thread, now) };
        Ok(stop.map(Leave::Turn).or(leave))
    }

    /// Ends the turn after an instruction that used time outside the program, or suspends it if the host interrupts.
    fn pause(&mut self, thread: &mut Thread, now: Time) -> Option<TurnEnd> {
        let elapsed = self.ports.take_elapsed();
        if elapsed == 0 {
            return self.ports.is_interrupted().then_some(TurnEnd::Suspended);
        }
        let wake = now.saturating_add(elapsed);
        thread.wait = Some(Wait { wake: Some(wake), sleeps: true, part: 0 });
        Some(TurnEnd::Pausing(wake))
    }

    /// Whether the task has halted or killed itself.
    fn is_stopped(&self) -> bool {
        let at = self.roster.position(self.task).and_then(|at| self.roster.tasks.get(at));
        at.is_some_and(|task| task.state != TaskState::Running)
    }

    /// Executes `watch`: returns the result, or `None` if the task waits (5.10). Instructions in its condition wait
    /// separately.
    pub(crate) fn watch(&mut self, thread: &mut Thread, holds: bool, seconds: f64) -> Option<bool> {
        let now = self.now();
        let wake = thread.watched.map(|since| since.saturating_add(nanoseconds(seconds)));
        let answer = match wake {
            _ if holds => Some(true),
            Some(wake) if now >= wake => Some(false),
            _ => None,
        };
        if answer.is_some() {
            thread.watched = None;
        } else {
            let since = thread.watched.unwrap_or(now);
            thread.watched = Some(since);
            let wake = Some(since.saturating_add(nanoseconds(seconds)));
            thread.wait = Some(Wait { wake, ..Wait::FOR_OTHERS });
        }
        answer
    }
}
