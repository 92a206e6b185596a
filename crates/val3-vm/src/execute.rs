//! The interpreter: executes the operations of a task's innermost program until the turn ends.
//!
//! This file contains the operations on numbers; [`values`](crate::values) contains the operations on strings and
//! structures, [`calls`](crate::calls) program calls, [`instruction`](crate::instruction) instructions.

use std::sync::Arc;

use val3_bytecode::{ContainerKind, LineMark, Op};
use val3_lang::call::Wait;
use val3_lang::fault::{Fault, Result};
use val3_lang::memory::{StoreId, View};
use val3_lang::runtime_errors::DIVISION_BY_ZERO;

use crate::arithmetic::{is_beyond, remainder, truth};
use crate::calls::program_of;
use crate::enter::leave;
use crate::instance::Imported;
use crate::operands::{OperandContext, located};
use crate::registers::{FixedRegisters, Registers};
use crate::task::Thread;
use crate::turn_context::TurnContext;
use crate::{Frame, Instance, TurnEnd};

/// Position of the interpreter, and the remaining budget.
pub(crate) struct Cursor {
    /// Next operation.
    pub(crate) next: usize,
    /// First operation of the current line.
    pub(crate) line: u32,
    pub(crate) budget: u32,
}

/// Reason for the interpreter to exit a program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Leave {
    /// The task continues in another application or library, with a frame of a different width, or with newly loaded
    /// libraries.
    Elsewhere,
    /// The turn has ended.
    Turn(TurnEnd),
}

/// Returns a local container or a library's container; `None` if it does not exist. These are rarer than global data
/// and views.
#[inline(never)]
fn container(kind: ContainerKind, frame: &Frame, parts: &[StoreId], instance: &Instance) -> Option<View> {
    match kind {
        ContainerKind::Part(number) => {
            parts.get(frame.base.part as usize + usize::from(number)).copied().map(View::whole)
        }
        ContainerKind::Import(number) => match instance.imports.get(usize::from(number)) {
            Some(Some(Imported::Data(store))) => Some(View::whole(*store)),
            _ => None,
        },
        ContainerKind::Data(_) | ContainerKind::View(_) | ContainerKind::Builtin(_) => None,
    }
}

impl TurnContext<'_> {
    /// Executes lines until the budget is used up or the turn ends.
    pub(crate) fn interpret(&mut self, thread: &mut Thread) -> Result<TurnEnd> {
        loop {
            // An instruction that loads a library replaces the instances, and `instances` becomes stale.
            let instances = Arc::clone(&self.space.instances);
            while Arc::ptr_eq(&instances, &self.space.instances) {
                let frame = *thread.frames.last().ok_or(Fault::INTERPRETER)?;
                let instance = instances.get(usize::from(frame.instance.0)).ok_or(Fault::INTERPRETER)?;
                let left = if FixedRegisters::suits(program_of(&frame, instance)?) {
                    self.programs::<FixedRegisters>(thread, frame, instance)
                } else {
                    self.programs::<[f64]>(thread, frame, instance)
                };
                if let Leave::Turn(stop) = left? {
                    return Ok(stop);
                }
            }
        }
    }

    /// Whether the task stops at the stop mark that it has reached: not where it has already stopped, and not if the
    /// guard excludes a stop.
    #[cold]
    fn meets_stop(&mut self, thread: &mut Thread, instance: &Instance, frame: &Frame, op: usize) -> bool {
        let task = self.roster.position(self.stops_as).and_then(|at| self.roster.tasks.get(at));
        let name = task.map_or("", |task| task.name.as_str());
        (thread.is_at_stop || !self.space.passes_stop(instance, frame, op, name)) && thread.meets_stop()
    }

    /// Executes programs in one application or library until the task exits it.
    #[inline(never)]
    fn programs<R: Registers + ?Sized>(
        &mut self,
        thread: &mut Thread,
        frame: Frame,
        instance: &Instance,
    ) -> Result<Leave> {
        let mut at = Cursor { next: thread.next as usize, line: thread.line, budget: self.budget };
        let left = self.operations::<R>(thread, frame, instance, &mut at);
        thread.next = u32::try_from(at.next).unwrap_or(u32::MAX);
        thread.line = at.line;
        self.budget = at.budget;
        left
    }

    /// Executes operations. `at` stays in processor registers, so other functions get its fields by value.
    #[allow(clippy::too_many_lines, reason = "one arm an operation, each of them short")]
    #[allow(clippy::neg_cmp_op_on_partial_ord, reason = "a comparison with what is no number does not hold")]
    #[allow(clippy::inline_always, reason = "only then is the cursor in registers")]
    #[inline(always)]
    fn operations<R: Registers + ?Sized>(
        &mut self,
        thread: &mut Thread,
        mut frame: Frame,
        instance: &Instance,
        at: &mut Cursor,
    ) -> Result<Leave> {
        let data = &*instance.data;
        let mut program = program_of(&frame, instance)?;
        let mut nums = R::of(&mut self.space.memory.stack.nums, &frame, program)?;

        macro_rules! scope {
            () => {
                OperandContext { instance, program, base: frame.base }
            };
        }
        // Runs `$work`, which may reallocate the stack, then borrows the registers again.
        macro_rules! outside {
            ($work:expr) => {{
                self.budget = at.budget;
                let result = $work;
                at.budget = self.budget;
                nums = R::of(&mut self.space.memory.stack.nums, &frame, program)?;
                result
            }};
        }
        // Looks up `$found` in the container `$view`; `None` if only the general way can find it or report the error.
        macro_rules! found {
            ($view:ident in $container:expr, $found:expr) => {{
                let view = match $container.kind() {
                    ContainerKind::Data(number) => data.get(usize::from(number)).copied().map(View::whole),
                    ContainerKind::View(number) => {
                        let at = frame.base.view as usize + usize::from(number);
                        self.space.memory.stack.views.get(at).copied()
                    }
                    kind => container(kind, &frame, &self.space.memory.stack.parts, instance),
                };
                match view {
                    Some($view) => $found,
                    None => None,
                }
            }};
        }
        // Loads a number that was looked up in a container.
        macro_rules! load {
            ($step:ident, $to:expr, $found:expr) => {
                match $found {
                    Some(number) => nums.set($to, *number)?,
                    None => outside!(self.on_values($step.op, scope!()))?,
                }
            };
        }
        // Stores a number at a location that was looked up in a container.
        macro_rules! store {
            ($step:ident, $from:expr, $found:expr) => {
                match $found {
                    Some(number) => *number = nums.get($from)?,
                    None => outside!(self.on_values($step.op, scope!()))?,
                }
            };
        }
        // Stores a view of a container that was looked up.
        macro_rules! view {
            ($step:ident, $to:expr, $found:expr) => {
                match $found {
                    Some(store) => {
                        let at = frame.base.view as usize + usize::from($to);
                        *self.space.memory.stack.views.get_mut(at).ok_or(Fault::INTERPRETER)? = View::whole(store);
                    }
                    None => outside!(self.on_values($step.op, scope!()))?,
                }
            };
        }
        // Stores the place of a value that was looked up.
        macro_rules! place {
            ($step:ident, $to:expr, $found:expr) => {
                match $found {
                    Some(place) => {
                        let at = frame.base.place as usize + usize::from($to);
                        *self.space.memory.stack.places.get_mut(at).ok_or(Fault::INTERPRETER)? = place;
                    }
                    None => outside!(self.on_values($step.op, scope!()))?,
                }
            };
        }
        // Continues with a different stack frame.
        macro_rules! change {
            ($frame:expr) => {{
                let other: Frame = $frame;
                if other.instance != frame.instance {
                    return Ok(Leave::Elsewhere);
                }
                frame = other;
                program = program_of(&frame, instance)?;
                if !R::suits(program) {
                    return Ok(Leave::Elsewhere);
                }
                nums = R::of(&mut self.space.memory.stack.nums, &frame, program)?;
            }};
        }

        while let Some(step) = program.code.get(at.next) {
            match step.mark {
                LineMark::Within => {}
                LineMark::StopWithin => {
                    if self.meets_stop(thread, instance, &frame, at.next) {
                        return Ok(Leave::Turn(TurnEnd::AtStop(self.task)));
                    }
                    nums = R::of(&mut self.space.memory.stack.nums, &frame, program)?;
                }
                LineMark::CountedSide(counter) => self.space.counts.add(instance.first_counter, program, counter),
                LineMark::Line | LineMark::Stop | LineMark::CountedLine(_) => {
                    let Some(left) = at.budget.checked_sub(1) else { return Ok(Leave::Turn(TurnEnd::Busy)) };
                    if self.watch.is_some() {
                        if !self.begins_watched_line(thread, frame, at.next) {
                            return Ok(Leave::Turn(TurnEnd::Busy));
                        }
                        nums = R::of(&mut self.space.memory.stack.nums, &frame, program)?;
                    }
                    if step.mark == LineMark::Stop {
                        if self.meets_stop(thread, instance, &frame, at.next) {
                            return Ok(Leave::Turn(TurnEnd::AtStop(self.task)));
                        }
                        nums = R::of(&mut self.space.memory.stack.nums, &frame, program)?;
                    }
                    if let LineMark::CountedLine(counter) = step.mark {
                        self.space.counts.add(instance.first_counter, program, counter);
                    }
                    at.budget = left;
                    #[allow(
                        clippy::cast_possible_truncation,
                        reason = "the compiler refuses programs of more operations"
                    )]
                    (at.line = at.next as u32);
                }
            }
            at.next += 1;
            match step.op {
                Op::Line => {}
                Op::Jump { to } => at.next = to as usize,
                Op::JumpUnless { condition, to } => {
                    if nums.get(condition)? == 0.0 {
                        at.next = to as usize;
                    }
                }
                Op::JumpIf { condition, to } => {
                    if nums.get(condition)? != 0.0 {
                        at.next = to as usize;
                    }
                }
                Op::IfLess { a, b, to } => {
                    if nums.get(a)? < nums.get(b)? {
                        at.next = to as usize;
                    }
                }
                Op::IfLessEqual { a, b, to } => {
                    if nums.get(a)? <= nums.get(b)? {
                        at.next = to as usize;
                    }
                }
                Op::UnlessLess { a, b, to } => {
                    if !(nums.get(a)? < nums.get(b)?) {
                        at.next = to as usize;
                    }
                }
                Op::UnlessLessEqual { a, b, to } => {
                    if !(nums.get(a)? <= nums.get(b)?) {
                        at.next = to as usize;
                    }
                }
                Op::UnlessEqual { a, b, to } => {
                    if nums.get(a)? != nums.get(b)? {
                        at.next = to as usize;
                    }
                }
                Op::IfEqual { a, b, to } => {
                    if nums.get(a)? == nums.get(b)? {
                        at.next = to as usize;
                    }
                }

                Op::Move { to, from } => nums.set(to, nums.get(from)?)?,
                Op::Add { to, a, b } => nums.set(to, nums.get(a)? + nums.get(b)?)?,
                Op::Subtract { to, a, b } => nums.set(to, nums.get(a)? - nums.get(b)?)?,
                Op::Multiply { to, a, b } => nums.set(to, nums.get(a)? * nums.get(b)?)?,
                Op::Divide { to, a, b } => {
                    let divisor = nums.get(b)?;
                    if divisor == 0.0 {
                        return Err(Fault(DIVISION_BY_ZERO));
                    }
                    nums.set(to, nums.get(a)? / divisor)?;
                }
                Op::Function { function, to, a, b, c } => {
                    nums.set(to, function.compute([nums.get(a)?, nums.get(b)?, nums.get(c)?])?)?;
                }
                Op::Remainder { to, a, b } => nums.set(to, remainder(nums.get(a)?, nums.get(b)?)?)?,
                Op::Negate { to, a } => nums.set(to, -nums.get(a)?)?,
                Op::Not { to, a } => nums.set(to, truth(nums.get(a)? == 0.0))?,
                Op::Less { to, a, b } => nums.set(to, truth(nums.get(a)? < nums.get(b)?))?,
                Op::LessEqual { to, a, b } => nums.set(to, truth(nums.get(a)? <= nums.get(b)?))?,
                Op::Equal { to, a, b } => nums.set(to, truth(nums.get(a)? == nums.get(b)?))?,
                Op::NotEqual { to, a, b } => nums.set(to, truth(nums.get(a)? != nums.get(b)?))?,

                Op::LoadFirst { to, container, lane } => {
                    load!(step, to, found!(view in container, self.space.memory.stores.first(view, lane)));
                }
                Op::StoreFirst { container, lane, from } => {
                    store!(step, from, found!(view in container, self.space.memory.stores.first_mut(view, lane)));
                }
                Op::LoadElement { to, container, index } => {
                    let at = nums.get(index)?;
                    load!(step, to, found!(view in container, self.space.memory.stores.element(view, at)));
                }
                Op::StoreElement { container, index, from } => {
                    let at = nums.get(index)?;
                    store!(step, from, found!(view in container, self.space.memory.stores.element_mut(view, at)));
                }
                Op::LoadElement2 { to, container, i, j } => {
                    let at = [nums.get(i)?, nums.get(j)?];
                    load!(step, to, found!(view in container, self.space.memory.stores.element2(view, at)));
                }
                Op::StoreElement2 { container, i, j, from } => {
                    let at = [nums.get(i)?, nums.get(j)?];
                    store!(step, from, found!(view in container, self.space.memory.stores.element2_mut(view, at)));
                }
                Op::LoadKey { to, container, key } => {
                    let value = {
                        let memory = &self.space.memory;
                        memory.num(scope!().keyed(memory, container, key)?, 0)?
                    };
                    nums = R::of(&mut self.space.memory.stack.nums, &frame, program)?;
                    nums.set(to, value)?;
                }
                Op::StoreKey { container, key, from } => {
                    let value = nums.get(from)?;
                    let place = scope!().keyed(&self.space.memory, container, key)?;
                    self.space.memory.set_num(place, 0, value)?;
                    nums = R::of(&mut self.space.memory.stack.nums, &frame, program)?;
                }
                Op::Load { to, place, lane } => {
                    let value =
                        self.space.memory.num(located(&self.space.memory, &frame.base, place)?, u32::from(lane))?;
                    nums = R::of(&mut self.space.memory.stack.nums, &frame, program)?;
                    nums.set(to, value)?;
                }
                Op::Store { place, lane, from } => {
                    let value = nums.get(from)?;
                    let place = located(&self.space.memory, &frame.base, place)?;
                    self.space.memory.set_num(place, u32::from(lane), value)?;
                    nums = R::of(&mut self.space.memory.stack.nums, &frame, program)?;
                }

                Op::FirstField { to, container, field } => {
                    view!(step, to, found!(view in container, self.space.memory.stores.field(view, field)));
                }
                Op::ElementField { to, container, index, field } => {
                    let at = nums.get(index)?;
                    view!(step, to, found!(view in container, self.space.memory.stores.element_field(view, at, field)));
                }

                Op::Field { to, place, field } => {
                    let place = located(&self.space.memory, &frame.base, place)?;
                    let store = self.space.memory.part(place, u32::from(field))?;
                    nums = R::of(&mut self.space.memory.stack.nums, &frame, program)?;
                    view!(step, to, Some(store));
                }
                Op::LocateFirst { to, container } => {
                    place!(step, to, found!(view in container, self.space.memory.stores.first_place(view)));
                }
                Op::Locate { to, container, index } => {
                    let at = nums.get(index)?;
                    place!(step, to, found!(view in container, self.space.memory.stores.element_place(view, at)));
                }
                Op::LocateKey { to, container, key } => {
                    let found = scope!().keyed(&self.space.memory, container, key)?;
                    nums = R::of(&mut self.space.memory.stack.nums, &frame, program)?;
                    place!(step, to, Some(found));
                }

                Op::TextMove { to, from } => outside!(self.move_text(&scope!(), to, from))?,
                Op::Concatenate { to, a, b } => outside!(self.concatenate(&scope!(), to, [a, b]))?,
                Op::TextEqual { to, a, b } => {
                    let equal = outside!(self.texts_equal(&scope!(), a, b))?;
                    nums.set(to, truth(equal))?;
                }
                Op::IfTextEqual { a, b, to } => {
                    if outside!(self.texts_equal(&scope!(), a, b))? {
                        at.next = to as usize;
                    }
                }
                Op::UnlessTextEqual { a, b, to } => {
                    if !outside!(self.texts_equal(&scope!(), a, b))? {
                        at.next = to as usize;
                    }
                }

                Op::ForTest { counter, limit, exit } => {
                    if is_beyond(nums.get(counter)?, nums.get(limit)?, nums.get(limit + 1)?) {
                        at.next = exit as usize;
                    }
                }
                Op::ForNext { counter, limit, body } => {
                    let step = nums.get(limit + 1)?;
                    let counted = nums.get(counter)? + step;
                    nums.set(counter, counted)?;
                    if !is_beyond(counted, nums.get(limit)?, step) {
                        at.next = body as usize;
                    }
                }

                Op::ForNextUp { counter, limit, body } => {
                    let counted = nums.get(counter)? + nums.get(limit + 1)?;
                    nums.set(counter, counted)?;
                    if !(counted > nums.get(limit)?) {
                        at.next = body as usize;
                    }
                }

                Op::Call { site } => {
                    let site = program.calls.get(site as usize).ok_or(Fault::INTERPRETER)?;
                    let inner = self.call(&frame, &scope!(), site, at.next, at.line)?;
                    if let Err(fault) = thread.push(inner, &mut self.space.memory.stores.room) {
                        leave(&mut self.space.memory, &inner.base);
                        return Err(fault);
                    }
                    (at.next, at.line) = (0, 0);
                    change!(inner);
                }
                Op::Return => {
                    if self.watch.is_some() && self.stops_before_return(thread, step.mark) {
                        at.next -= 1;
                        return Ok(Leave::Turn(TurnEnd::AtStop(self.task)));
                    }
                    if self.space.stops_at_ends && thread.meets_end() {
                        at.next -= 1;
                        return Ok(Leave::Turn(TurnEnd::AtStop(self.task)));
                    }
                    leave(&mut self.space.memory, &frame.base);
                    let [.., caller, _] = thread.frames.as_slice() else {
                        // The frame remains, because it contains the position at which the task ended.
                        return Ok(Leave::Turn(TurnEnd::Finished));
                    };
                    (at.next, at.line) = (frame.back as usize, frame.back_line);
                    let caller = *caller;
                    thread.frames.pop();
                    change!(caller);
                }
                Op::Instruction { site } => {
                    let site = program.instructions.get(site as usize).ok_or(Fault::INTERPRETER)?;
                    if let Some(leave) = outside!(self.instruction(thread, scope!(), &frame, at.line, site))? {
                        at.next -= usize::from(matches!(leave, Leave::Turn(TurnEnd::Waiting(_))));
                        return Ok(leave);
                    }
                }
                Op::CreateTask { site } => {
                    let site = program.tasks.get(site as usize).ok_or(Fault::INTERPRETER)?;
                    outside!(self.create_task(scope!(), &frame, at.line, site))?;
                }
                Op::WaitUntil { condition, retry } => {
                    if nums.get(condition)? == 0.0 {
                        thread.wait = Some(Wait::default());
                        at.next = retry as usize;
                        return Ok(Leave::Turn(TurnEnd::Waiting(None)));
                    }
                }
                Op::Watch { to, condition, seconds, retry } => {
                    let (holds, seconds) = (nums.get(condition)? != 0.0, nums.get(seconds)?);
                    let Some(answer) = outside!(self.watch(thread, holds, seconds)) else {
                        at.next = retry as usize;
                        return Ok(Leave::Turn(TurnEnd::Waiting(thread.wait.and_then(|wait| wait.wake))));
                    };
                    nums.set(to, truth(answer))?;
                }
                // All other operations are listed, so that the jump table covers every operation.
                Op::Locate2 { .. } | Op::Locate3 { .. } | Op::Copy { .. } | Op::Compare { .. } => {
                    outside!(self.on_values(step.op, scope!()))?
                }
            }
        }
        Err(Fault::INTERPRETER)
    }
}
