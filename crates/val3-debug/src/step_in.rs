//! The program or task into which the next line of a task leads.

use val3_bytecode::Op;
use val3_lang::ports::TaskNumber;

use crate::called::called_program;
use crate::debugger::Debugger;
use crate::step::StepKind;

/// A program that the next line of a task calls, or with which a task begins that it creates.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct StepInTarget {
    /// The application or library that the program belongs to.
    pub application: String,
    /// The name of the program.
    pub program: String,
    /// The step that leads there.
    pub kind: StepKind,
}

impl Debugger {
    /// Where the next line of a task leads; nowhere if it neither calls a program nor creates a task.
    #[must_use]
    pub fn step_in_target(&self, task: TaskNumber) -> Option<StepInTarget> {
        let vm = &self.controller.vm;
        let thread = &vm.tasks().iter().find(|known| known.id == task)?.thread;
        let frame = thread.frames.last()?;
        let image = &vm.space.instance(frame.instance)?.image;
        let program = image.programs.get(usize::from(frame.program))?;
        let line = program.line_of(thread.next)?;
        let operations = (thread.next..).zip(program.code.get(thread.next as usize..)?);
        // The operations of a line follow one another.
        let mut operations =
            operations.take_while(|(op, _)| program.line_of(*op) == Some(line)).map(|(_, step)| &step.op);
        let (site, kind) = operations.find_map(|op| match op {
            Op::Call { site } => Some((program.calls.get(*site as usize)?, StepKind::In)),
            Op::CreateTask { site } => Some((&program.tasks.get(*site as usize)?.call, StepKind::IntoTask)),
            _ => None,
        })?;
        let (instance, number) = called_program(vm, frame.instance, site)?;
        let owner = &vm.space.instance(instance)?.image;
        let program = owner.programs.get(usize::from(number))?;
        Some(StepInTarget { application: owner.name.clone(), program: program.name.clone(), kind })
    }
}
