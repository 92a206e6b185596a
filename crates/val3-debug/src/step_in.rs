//! Targets for stepping into a line: the called program or the created task.

use val3_bytecode::Op;
use val3_lang::ports::TaskNumber;

use crate::debugger::Debugger;
use crate::step::{Step, StepKind};

/// Program that the task's next line calls, or with which a task begins that the line creates.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct StepInTarget {
    /// Application or library of the program.
    pub application: String,
    /// Program name.
    pub program: String,
    /// Kind of step into the program.
    pub kind: StepKind,
}

impl Debugger {
    /// Starts a step of a task into the program that its next line calls, or with which a created task begins, also if
    /// steps [skip](Self::skip) the program.
    pub fn step_into(&mut self, task: TaskNumber, target: &StepInTarget) {
        self.step(task, target.kind);
        self.step = self.step.map(Step::into_target);
    }

    /// Returns the program that the task's next line calls or starts as a task; `None` if the line does neither.
    #[must_use]
    pub fn step_in_target(&self, task: TaskNumber) -> Option<StepInTarget> {
        let vm = &self.controller.vm;
        let thread = &vm.tasks().iter().find(|known| known.id == task)?.thread;
        let frame = thread.frames.last()?;
        let image = &vm.space.instance(frame.instance)?.image;
        let program = image.programs.get(usize::from(frame.program))?;
        let line = program.line_of(thread.next)?;
        let operations = (thread.next..).zip(program.code.get(thread.next as usize..)?);
        // The operations of a line are contiguous.
        let mut operations =
            operations.take_while(|(op, _)| program.line_of(*op) == Some(line)).map(|(_, step)| &step.op);
        let (site, kind) = operations.find_map(|op| match op {
            Op::Call { site } => Some((program.calls.get(*site as usize)?, StepKind::In)),
            Op::CreateTask { site } => Some((&program.tasks.get(*site as usize)?.call, StepKind::IntoTask)),
            _ => None,
        })?;
        let called = vm.space.called(frame.instance, site.program)?;
        let owner = &vm.space.instance(called.instance)?.image;
        let program = owner.programs.get(usize::from(called.number))?;
        Some(StepInTarget { application: owner.name.clone(), program: program.name.clone(), kind })
    }
}
