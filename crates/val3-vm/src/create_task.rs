//! Creation of tasks (5.10).

use std::sync::Arc;

use val3_bytecode::{ProgramParam, Storage, TaskSite};
use val3_lang::call::Argument;
use val3_lang::fault::{Fault, Result};
use val3_lang::memory::{Memory, Place};
use val3_lang::ports::{TaskChange, Time};
use val3_lang::tasks::{period_steps, priority};
use val3_lang::types::BaseType;
use val3_lang::versions::Version;

use crate::enter::{enter_with, write};
use crate::operands::OperandContext;
use crate::task::{Base, NewThread, Thread};
use crate::turn_context::TurnContext;
use crate::{CYCLE, Frame, ProgramId, Rate};

impl TurnContext<'_> {
    /// Executes `taskCreate` or `taskCreateSync` (5.10).
    pub(crate) fn create_task(
        &mut self,
        scope: OperandContext<'_>,
        frame: &Frame,
        line: u32,
        site: &TaskSite,
    ) -> Result<()> {
        self.ports.origin(self.origin(self.now(), frame, line));
        let (memory, image) = (&self.space.memory, &scope.instance.image);
        let name = scope.text(memory, site.name)?.as_str().to_owned();
        self.roster.check_name(frame.instance, &name, image.version)?;
        let rate = scope.num(memory, site.rate)?;
        let overrun = site.overrun.map(|operand| scope.place(memory, operand)).transpose()?;
        let arguments = site.call.arguments.iter().map(|site| scope.argument(memory, site));
        let arguments = arguments.collect::<Result<Vec<_>>>()?;
        let rate = self.rate(rate, overrun, image.version)?;
        let called = self.space.called(frame.instance, site.call.program).ok_or(Fault::LIBRARY_ITEM_MISSING)?;
        let thread = self.new_thread(called, &arguments, image.stack_size)?;
        let id = self.roster.new_id();
        self.ports.task(id, &name, TaskChange::Created, thread.place());
        self.roster.add(id, &name, frame.instance, rate, NewThread { thread, stack_size: image.stack_size });
        self.end_with_turn();
        Ok(())
    }

    fn rate(&self, rate: f64, overrun: Option<Place>, version: Version) -> Result<Rate> {
        let Some(overrun) = overrun else {
            let lines = (rate + 0.5).floor();
            let suits = priority().is_some_and(|range| range.takes(lines));
            #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "1 to 100")]
            return if suits { Ok(Rate::Priority(lines as u32)) } else { Err(Fault::INVALID_PARAMETER) };
        };
        if self.space.memory.is_local(overrun.store) {
            return Err(Fault::INVALID_PARAMETER);
        }
        let least = u32::from(version.lengthens_short_periods());
        let steps = period_steps(rate).map(|steps| steps.max(least)).filter(|steps| *steps > 0);
        let steps = steps.ok_or(Fault::INVALID_PARAMETER)?;
        let period = Time::from(steps) * CYCLE;
        self.roster.check_period(period)?;
        let next = self.now().next_multiple_of(period);
        Ok(Rate::Period { period, next, overrun, late: false, overruns: 0 })
    }

    /// Creates the thread of a new task with a stack of `stack_size` bytes. Its frame is built after the creator's
    /// frames, from which argument values are copied, and then moved to a separate stack.
    pub(crate) fn new_thread(&mut self, program: ProgramId, arguments: &[Argument], stack_size: u32) -> Result<Thread> {
        let ProgramId { instance, number } = program;
        let image = Arc::clone(&self.space.instance(instance).ok_or(Fault::INTERPRETER)?.image);
        let callee = image.programs.get(usize::from(number)).ok_or(Fault::INTERPRETER)?;
        let references = callee.params.iter().zip(arguments).filter(|(param, _)| is_reference(param.storage));
        if references.map(|(_, argument)| argument).any(|argument| is_local(&self.space.memory, *argument)) {
            return Err(Fault::INVALID_PARAMETER);
        }
        let stack = &self.space.memory.stack;
        let lanes = stack.ends();
        let (place, view) = (length(&stack.places), length(&stack.views));
        let base = Base { num: lanes.num, text: lanes.text, link: lanes.link, part: lanes.part, place, view, bytes: 0 };
        let memory = &mut self.space.memory;
        let mut thread = Thread::new(&mut memory.stores.room)?;
        let frame = Frame { instance, program: number, back: 0, back_line: 0, base: Base::default() };
        let entered = thread.push(frame, &mut memory.stores.room);
        let entered = entered.and_then(|()| enter_with(memory, callee, &base, stack_size, arguments));
        thread.stack = memory.stack.split_off(lanes, place, view);
        if entered.is_err() {
            thread.give_back(&mut memory.stores.room);
        }
        entered.map(|()| thread)
    }
}

impl TurnContext<'_> {
    /// Creates the thread of a new task whose program has `num` parameters by value, and passes `numbers` to them.
    pub(crate) fn new_thread_with(&mut self, program: ProgramId, numbers: &[f64]) -> Result<Thread> {
        let image = self.space.instance(program.instance).map(|instance| Arc::clone(&instance.image));
        let image = image.ok_or(Fault::INTERPRETER)?;
        let params = image.programs.get(usize::from(program.number)).map(|program| &program.params);
        let lanes: Vec<u32> = params.into_iter().flatten().filter_map(number_lane).collect();
        if params.map(Vec::len) != Some(numbers.len()) || lanes.len() != numbers.len() {
            return Err(Fault::INVALID_PARAMETER);
        }
        let mut thread = self.new_thread(program, &[], self.stack_size)?;
        lanes.iter().zip(numbers).try_for_each(|(lane, number)| write(&mut thread.stack.nums, *lane, *number))?;
        Ok(thread)
    }
}

/// Returns the lane of a `num` parameter by value.
fn number_lane(param: &ProgramParam) -> Option<u32> {
    match param.storage {
        Storage::Value(lanes) if param.kind.base_type() == Some(BaseType::Num) => Some(lanes.num),
        _ => None,
    }
}

fn length<T>(lanes: &[T]) -> u32 {
    u32::try_from(lanes.len()).unwrap_or(u32::MAX)
}

fn is_reference(parameter: Storage) -> bool {
    matches!(parameter, Storage::Place(_) | Storage::View(_))
}

/// Whether the argument is a local variable of the creator, which the new task may outlive (5.10).
fn is_local(memory: &Memory, argument: Argument) -> bool {
    match argument {
        Argument::Value(place, _) | Argument::UserValue(place) => memory.is_local(place.store),
        Argument::View(view) => memory.is_local(view.store),
        Argument::Slot(_) | Argument::Library(_) => false,
    }
}
