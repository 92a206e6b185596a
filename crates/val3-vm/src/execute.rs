//! The interpreter: steps of the innermost program of one task, until its turn ends.
//!
//! Here are the operations on numbers; [`values`](crate::values) has those on texts and structures,
//! [`calls`](crate::calls) programs that call others, [`instruction`](crate::instruction) instructions.

use std::sync::Arc;

use val3_bytecode::{Image, Op, WholeKind};
use val3_lang::call::Wait;
use val3_lang::fault::{Fault, Result};
use val3_lang::memory::{StoreId, View};
use val3_lang::runtime_errors::DIVISION_BY_ZERO;

use crate::arithmetic::{is_beyond, remainder, truth};
use crate::calls::program_of;
use crate::enter::leave;
use crate::instance::Imported;
use crate::task::Thread;
use crate::turn_context::TurnContext;
use crate::window::{Narrow, Window};
use crate::{Frame, Instance, Outcome};

/// Where the interpreter is, and the lines that it may still begin.
pub(crate) struct Cursor {
    /// The next step.
    pub(crate) next: usize,
    /// The first step of the line at hand.
    pub(crate) line: u32,
    pub(crate) budget: u32,
}

/// Why the interpreter leaves a program.
pub(crate) enum Leave {
    /// The task goes on in a program of another application, or with a frame of another width.
    Elsewhere,
    /// The turn is over.
    Turn(Outcome),
}

/// A container of the frame or of a library, where there is one: parts, views and applications are those of the
/// machine. It is marked as rare so that the way to global data, by far the most frequent, needs no registers for it.
#[cold]
fn container(
    kind: WholeKind,
    frame: &Frame,
    (parts, views, instances): (&[StoreId], &[View], &[Instance]),
) -> Option<View> {
    match kind {
        WholeKind::Part(number) => parts.get(frame.base.part as usize + usize::from(number)).copied().map(View::whole),
        WholeKind::View(number) => views.get(frame.base.view as usize + usize::from(number)).copied(),
        WholeKind::Import(number) => {
            match instances.get(usize::from(frame.instance.0))?.imports.get(usize::from(number)) {
                Some(Some(Imported::Data(store))) => Some(View::whole(*store)),
                _ => None,
            }
        }
        WholeKind::Data(_) | WholeKind::Builtin(_) => None,
    }
}

impl TurnContext<'_> {
    /// Executes lines until the budget is used up or the turn ends.
    pub(crate) fn interpret(&mut self, thread: &mut Thread) -> Result<Outcome> {
        loop {
            let frame = *thread.frames.last().ok_or(Fault::INTERPRETER)?;
            let instance = self.instance(frame.instance)?;
            let (image, data) = (Arc::clone(&instance.image), Arc::clone(&instance.data));
            let left = if Narrow::suits(program_of(&frame, &image)?) {
                self.programs::<Narrow>(thread, frame, (&image, &data))
            } else {
                self.programs::<[f64]>(thread, frame, (&image, &data))
            };
            if let Leave::Turn(stop) = left? {
                return Ok(stop);
            }
        }
    }

    /// Executes programs of one application until it is left.
    #[inline(never)]
    fn programs<W: Window + ?Sized>(
        &mut self,
        thread: &mut Thread,
        frame: Frame,
        application: (&Image, &[StoreId]),
    ) -> Result<Leave> {
        let mut at = Cursor { next: thread.next as usize, line: thread.line, budget: self.budget };
        let left = self.steps::<W>(thread, frame, application, &mut at);
        thread.next = u32::try_from(at.next).unwrap_or(u32::MAX);
        thread.line = at.line;
        self.budget = at.budget;
        left
    }

    /// The steps. `at` is kept in registers: whoever needs it gets it as a value.
    #[allow(clippy::too_many_lines, reason = "one arm an operation, each of them short")]
    #[allow(clippy::neg_cmp_op_on_partial_ord, reason = "a comparison with what is no number does not hold")]
    #[allow(clippy::inline_always, reason = "only then is the cursor in registers")]
    #[inline(always)]
    fn steps<W: Window + ?Sized>(
        &mut self,
        thread: &mut Thread,
        mut frame: Frame,
        (image, data): (&Image, &[StoreId]),
        at: &mut Cursor,
    ) -> Result<Leave> {
        let mut program = program_of(&frame, image)?;
        let mut nums = W::of(&mut self.space.memory.stack.nums, &frame, program)?;

        // Whatever reaches into the memory as a whole; the numbers are looked up anew behind it.
        macro_rules! outside {
            ($work:expr) => {{
                self.budget = at.budget;
                let result = $work;
                at.budget = self.budget;
                nums = W::of(&mut self.space.memory.stack.nums, &frame, program)?;
                result
            }};
        }
        // `$found` in the container `$view`; `None` where it takes the general way, which tells why there is none.
        macro_rules! found {
            ($view:ident in $whole:expr, $found:expr) => {{
                let view = match $whole.data() {
                    Some(number) => data.get(usize::from(number)).copied().map(View::whole),
                    None => {
                        let (parts, views) = (&*self.space.memory.stack.parts, &*self.space.memory.stack.views);
                        container($whole.kind(), &frame, (parts, views, &self.space.instances))
                    }
                };
                match view {
                    Some($view) => $found,
                    None => None,
                }
            }};
        }
        // Reads a number of a container that was found.
        macro_rules! load {
            ($step:ident, $to:expr, $found:expr) => {
                match $found {
                    Some(number) => nums.set($to, *number)?,
                    None => outside!(self.on_values($step.op, &frame, program))?,
                }
            };
        }
        // Writes one.
        macro_rules! store {
            ($step:ident, $from:expr, $found:expr) => {
                match $found {
                    Some(number) => *number = nums.get($from)?,
                    None => outside!(self.on_values($step.op, &frame, program))?,
                }
            };
        }
        // Goes on in the program with another frame.
        macro_rules! change {
            ($frame:expr) => {{
                let other: Frame = $frame;
                if other.instance != frame.instance {
                    return Ok(Leave::Elsewhere);
                }
                frame = other;
                program = program_of(&frame, image)?;
                if !W::suits(program) {
                    return Ok(Leave::Elsewhere);
                }
                nums = W::of(&mut self.space.memory.stack.nums, &frame, program)?;
            }};
        }

        while let Some(step) = program.code.get(at.next) {
            if step.line {
                match at.budget.checked_sub(1) {
                    Some(left) => at.budget = left,
                    None => return Ok(Leave::Turn(Outcome::Busy)),
                }
                #[allow(clippy::cast_possible_truncation, reason = "the compiler refuses programs of more steps")]
                (at.line = at.next as u32);
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

                Op::LoadFirst { to, whole, lane } => {
                    load!(step, to, found!(view in whole, self.space.memory.stores.first(view, lane)));
                }
                Op::StoreFirst { whole, lane, from } => {
                    store!(step, from, found!(view in whole, self.space.memory.stores.first_mut(view, lane)));
                }
                Op::LoadElement { to, whole, index } => {
                    let at = nums.get(index)?;
                    load!(step, to, found!(view in whole, self.space.memory.stores.element(view, at)));
                }
                Op::StoreElement { whole, index, from } => {
                    let at = nums.get(index)?;
                    store!(step, from, found!(view in whole, self.space.memory.stores.element_mut(view, at)));
                }
                Op::LoadElement2 { to, whole, i, j } => {
                    let at = [nums.get(i)?, nums.get(j)?];
                    load!(step, to, found!(view in whole, self.space.memory.stores.element2(view, at)));
                }
                Op::StoreElement2 { whole, i, j, from } => {
                    let at = [nums.get(i)?, nums.get(j)?];
                    store!(step, from, found!(view in whole, self.space.memory.stores.element2_mut(view, at)));
                }
                Op::Load { to, place, lane } => {
                    let value = self.load_num(&frame, place, lane)?;
                    nums = W::of(&mut self.space.memory.stack.nums, &frame, program)?;
                    nums.set(to, value)?;
                }
                Op::Store { place, lane, from } => {
                    let value = nums.get(from)?;
                    self.store_num(&frame, (place, lane), value)?;
                    nums = W::of(&mut self.space.memory.stack.nums, &frame, program)?;
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
                    let inner = self.call(image, (&frame, program), site, (at.next, at.line))?;
                    if let Err(fault) = thread.push(inner, &mut self.space.memory.stores.room) {
                        leave(&mut self.space.memory, &inner.base);
                        return Err(fault);
                    }
                    (at.next, at.line) = (0, 0);
                    change!(inner);
                }
                Op::Return => {
                    leave(&mut self.space.memory, &frame.base);
                    let [.., caller, _] = thread.frames.as_slice() else {
                        // The frame stays: it tells where the task has ended.
                        return Ok(Leave::Turn(Outcome::Finished));
                    };
                    (at.next, at.line) = (frame.back as usize, frame.back_line);
                    let caller = *caller;
                    thread.frames.pop();
                    change!(caller);
                }
                Op::Instruction { site } => {
                    let site = program.instructions.get(site as usize).ok_or(Fault::INTERPRETER)?;
                    if let Some(stop) = outside!(self.instruction(thread, image, (&frame, at.line), site))? {
                        at.next -= usize::from(matches!(stop, Outcome::Waiting(_)));
                        return Ok(Leave::Turn(stop));
                    }
                }
                Op::CreateTask { site } => {
                    let site = program.tasks.get(site as usize).ok_or(Fault::INTERPRETER)?;
                    outside!(self.create_task(image, (&frame, at.line), site))?;
                }
                Op::WaitUntil { condition, retry } => {
                    if nums.get(condition)? == 0.0 {
                        thread.wait = Some(Wait::default());
                        at.next = retry as usize;
                        return Ok(Leave::Turn(Outcome::Waiting(None)));
                    }
                }
                Op::Watch { to, condition, seconds, retry } => {
                    let (holds, seconds) = (nums.get(condition)? != 0.0, nums.get(seconds)?);
                    let Some(answer) = outside!(self.watch(thread, holds, seconds)) else {
                        at.next = retry as usize;
                        return Ok(Leave::Turn(Outcome::Waiting(thread.wait.and_then(|wait| wait.wake))));
                    };
                    nums.set(to, truth(answer))?;
                }
                // All others by name: only then is no number of an operation beyond the table of jumps.
                Op::TextConstant { .. }
                | Op::TextMove { .. }
                | Op::Concatenate { .. }
                | Op::TextEqual { .. }
                | Op::LocateFirst { .. }
                | Op::Locate { .. }
                | Op::Locate2 { .. }
                | Op::Locate3 { .. }
                | Op::LocateKey { .. }
                | Op::Field { .. }
                | Op::LoadText { .. }
                | Op::StoreText { .. }
                | Op::Copy { .. }
                | Op::Compare { .. } => outside!(self.on_values(step.op, &frame, program))?,
            }
        }
        Err(Fault::INTERPRETER)
    }
}
