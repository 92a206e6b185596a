//! The interpreter: operations of the innermost program of one task, until its turn ends.

use std::sync::Arc;

use val3_bytecode::{
    ArgumentSite, CallSite, Handler, Image, InstructionSite, Op, Operand, Passing, Program, ProgramRef, Register,
};
use val3_lang::call::{Argument, Call, Flow, Wait, Waiting};
use val3_lang::fault::{Fault, Result};
use val3_lang::memory::{Memory, Place, StoreId, View};
use val3_lang::ports::{CodePlace, Origin, Ports, TaskNumber, Tasks, Time, nanoseconds};
use val3_lang::runtime_errors::DIVISION_BY_ZERO;
use val3_lang::types::BaseType;
use val3_lang::values::Text;

use crate::arguments::{Given, Scope};
use crate::arithmetic::{concatenate, is_beyond, remainder};
use crate::enter::{behind, enter, leave, pass, pass_number};
use crate::instance::Imported;
use crate::roster::Roster;
use crate::services::{Changes, Services};
use crate::task::{Base, Thread};
use crate::{Frame, Grant, Host, Instance, InstanceId, Space, Stop, TaskState};

/// What the interpreter works on during one turn.
pub(crate) struct Machine<'v> {
    pub(crate) space: &'v mut Space,
    pub(crate) roster: &'v mut Roster,
    pub(crate) ports: &'v mut dyn Host,
    /// The task that runs.
    pub(crate) task: TaskNumber,
    pub(crate) stack_size: u32,
    /// What it may execute.
    pub(crate) grant: Grant,
    /// How many lines that is.
    pub(crate) granted: u32,
    /// Lines that may still be executed.
    pub(crate) budget: u32,
    /// The time at which the budget is used up, and what a line takes: the time now follows from both.
    pub(crate) end: Time,
    pub(crate) line_cost: Time,
    /// Something asked for the time.
    pub(crate) reads_clock: bool,
    /// The arguments of the last instruction; their room serves the next one.
    pub(crate) arguments: Vec<Argument>,
}

/// How the interpreter leaves a program.
enum Leave {
    /// For another program of the same application.
    Program,
    /// For a program of another one.
    Instance,
    /// The turn is over.
    Turn(Stop),
}

impl Machine<'_> {
    /// Executes lines until the turn ends.
    pub(crate) fn run(&mut self, thread: &mut Thread) -> Result<Stop> {
        loop {
            let frame = *thread.frames.last().ok_or(Fault::INTERPRETER)?;
            let instance = self.instance(frame.instance)?;
            let (image, data) = (Arc::clone(&instance.image), Arc::clone(&instance.data));
            if let Leave::Turn(stop) = self.programs(thread, &image, &data)? {
                return Ok(stop);
            }
        }
    }

    fn instance(&self, id: InstanceId) -> Result<&Instance> {
        self.space.instance(id).ok_or(Fault::INTERPRETER)
    }

    pub(crate) fn now(&self) -> Time {
        self.end - Time::from(self.budget) * self.line_cost
    }

    /// Executes programs of one application until it is left.
    #[allow(clippy::too_many_lines, reason = "one arm an operation, each of them short")]
    #[allow(clippy::neg_cmp_op_on_partial_ord, reason = "a comparison with what is no number does not hold")]
    fn programs(&mut self, thread: &mut Thread, image: &Arc<Image>, data: &[StoreId]) -> Result<Leave> {
        let (mut frame, mut program) = innermost(thread, image)?;
        let mut next = thread.next as usize;

        // The numbers of the frame. Whatever else reaches into the memory comes before they are looked up anew.
        macro_rules! frame {
            () => {
                match self.space.memory.stack.nums.get_mut(numbers(frame, program)) {
                    Some(frame) => frame,
                    None => return Err(Fault::INTERPRETER),
                }
            };
        }
        let mut nums = frame!();
        macro_rules! get {
            ($register:expr) => {
                match nums.get(usize::from($register)) {
                    Some(number) => *number,
                    None => return Err(Fault::INTERPRETER),
                }
            };
        }
        macro_rules! set {
            ($register:expr, $value:expr) => {{
                let value: f64 = $value;
                match nums.get_mut(usize::from($register)) {
                    Some(number) => *number = value,
                    None => return Err(Fault::INTERPRETER),
                }
            }};
        }
        macro_rules! truth {
            ($value:expr) => {
                f64::from(u8::from($value))
            };
        }
        macro_rules! leave {
            ($at:expr, $leave:expr) => {{
                thread.next = u32::try_from($at).unwrap_or(u32::MAX);
                return Ok($leave);
            }};
        }
        macro_rules! view {
            ($whole:expr) => {
                match $whole.kind() {
                    val3_bytecode::WholeKind::Data(number) => match data.get(usize::from(number)) {
                        Some(store) => View::whole(*store),
                        None => return Err(Fault::INTERPRETER),
                    },
                    _ => {
                        let view = self.scope(frame)?.view($whole)?;
                        nums = frame!();
                        view
                    }
                }
            };
        }

        macro_rules! change {
            ($leave:expr) => {{
                let leave = $leave;
                if !matches!(leave, Leave::Program) {
                    return Ok(leave);
                }
                (frame, program) = innermost(thread, image)?;
                next = thread.next as usize;
                nums = frame!();
            }};
        }

        while let Some(op) = program.code.get(next) {
            next += 1;
            match *op {
                Op::Line => {
                    if self.budget == 0 {
                        leave!(next - 1, Leave::Turn(Stop::Budget));
                    }
                    self.budget -= 1;
                    thread.line = u32::try_from(next - 1).unwrap_or(u32::MAX);
                }
                Op::Jump { to } => next = to as usize,
                Op::JumpToLine { to } => {
                    if self.budget == 0 {
                        leave!(to, Leave::Turn(Stop::Budget));
                    }
                    self.budget -= 1;
                    thread.line = to;
                    next = to as usize + 1;
                }
                Op::JumpUnless { condition, to } => {
                    if get!(condition) == 0.0 {
                        next = to as usize;
                    }
                }
                Op::JumpIf { condition, to } => {
                    if get!(condition) != 0.0 {
                        next = to as usize;
                    }
                }
                Op::UnlessLess { a, b, to } => {
                    if !(get!(a) < get!(b)) {
                        next = to as usize;
                    }
                }
                Op::UnlessLessEqual { a, b, to } => {
                    if !(get!(a) <= get!(b)) {
                        next = to as usize;
                    }
                }
                Op::UnlessEqual { a, b, to } => {
                    if get!(a) != get!(b) {
                        next = to as usize;
                    }
                }
                Op::IfEqual { a, b, to } => {
                    if get!(a) == get!(b) {
                        next = to as usize;
                    }
                }

                Op::Move { to, from } => set!(to, get!(from)),
                Op::Add { to, a, b } => set!(to, get!(a) + get!(b)),
                Op::Subtract { to, a, b } => set!(to, get!(a) - get!(b)),
                Op::Multiply { to, a, b } => set!(to, get!(a) * get!(b)),
                Op::Divide { to, a, b } => {
                    let divisor = get!(b);
                    if divisor == 0.0 {
                        return Err(Fault(DIVISION_BY_ZERO));
                    }
                    set!(to, get!(a) / divisor);
                }
                Op::Remainder { to, a, b } => set!(to, remainder(get!(a), get!(b))?),
                Op::Negate { to, a } => set!(to, -get!(a)),
                Op::Not { to, a } => set!(to, truth!(get!(a) == 0.0)),
                Op::Less { to, a, b } => set!(to, truth!(get!(a) < get!(b))),
                Op::LessEqual { to, a, b } => set!(to, truth!(get!(a) <= get!(b))),
                Op::Equal { to, a, b } => set!(to, truth!(get!(a) == get!(b))),
                Op::NotEqual { to, a, b } => set!(to, truth!(get!(a) != get!(b))),

                Op::TextConstant { to, constant } => {
                    let at = frame.base.text as usize + usize::from(to);
                    let to = self.space.memory.stack.texts.get_mut(at).ok_or(Fault::INTERPRETER)?;
                    *to = *program.texts.get(usize::from(constant)).ok_or(Fault::INTERPRETER)?;
                }
                Op::TextMove { to, from } => {
                    let text = *self.text(frame.base, from)?;
                    self.set_text(frame.base, to, text)?;
                    nums = frame!();
                }
                Op::Concatenate { to, a, b } => {
                    let first = frame.base.text as usize;
                    let texts = self.space.memory.stack.texts.get_mut(first..).ok_or(Fault::INTERPRETER)?;
                    concatenate(texts, to, (a, b))?;
                }
                Op::TextEqual { to, a, b } => {
                    let equal = self.text(frame.base, a)? == self.text(frame.base, b)?;
                    nums = frame!();
                    set!(to, truth!(equal));
                }

                Op::LoadFirst { to, whole, lane } => {
                    let view = view!(whole);
                    set!(to, self.space.memory.stores.first_num(view, u32::from(lane))?);
                }
                Op::StoreFirst { whole, lane, from } => {
                    let (view, value) = (view!(whole), get!(from));
                    self.space.memory.stores.set_first_num(view, u32::from(lane), value)?;
                }
                Op::LoadElement { to, whole, index } => {
                    let (view, index) = (view!(whole), get!(index));
                    set!(to, self.space.memory.stores.element_num(view, index)?);
                }
                Op::StoreElement { whole, index, from } => {
                    let (view, index, value) = (view!(whole), get!(index), get!(from));
                    self.space.memory.stores.set_element_num(view, index, value)?;
                }
                Op::LoadElement2 { to, whole, i, j } => {
                    let (view, at) = (view!(whole), [get!(i), get!(j)]);
                    set!(to, self.space.memory.stores.element2_num(view.store, at)?);
                }
                Op::StoreElement2 { whole, i, j, from } => {
                    let (view, at, value) = (view!(whole), [get!(i), get!(j)], get!(from));
                    self.space.memory.stores.set_element2_num(view.store, at, value)?;
                }

                Op::LocateFirst { to, whole } => {
                    let view = self.scope(frame)?.view(whole)?;
                    let place = self.space.memory.element(view, 0)?;
                    self.set_place(frame.base, to, place)?;
                    nums = frame!();
                }
                Op::Locate { to, whole, index } => {
                    let (view, index) = (view!(whole), get!(index));
                    let store = self.space.memory.store(view.store)?;
                    let place = store.place(view.store, store.number1(view, index)?);
                    self.set_place(frame.base, to, place)?;
                    nums = frame!();
                }
                Op::Locate2 { to, whole, i, j } => {
                    let (view, at) = (view!(whole), [get!(i), get!(j)]);
                    let store = self.space.memory.store(view.store)?;
                    let place = store.place(view.store, store.number2(at)?);
                    self.set_place(frame.base, to, place)?;
                    nums = frame!();
                }
                Op::Locate3 { to, whole, i } => {
                    let (view, at) = (view!(whole), [get!(i), get!(i + 1), get!(i + 2)]);
                    let store = self.space.memory.store(view.store)?;
                    let place = store.place(view.store, store.number3(at)?);
                    self.set_place(frame.base, to, place)?;
                    nums = frame!();
                }
                Op::LocateKey { to, whole, key } => {
                    let (view, key) = (self.scope(frame)?.view(whole)?, *self.text(frame.base, key)?);
                    let store = self.space.memory.store(view.store)?;
                    let place = store.place(view.store, store.number_of(&key)?);
                    self.set_place(frame.base, to, place)?;
                    nums = frame!();
                }
                Op::Field { to, place, field } => {
                    let place = self.scope(frame)?.located(place)?;
                    let view = View::whole(self.space.memory.part(place, u32::from(field))?);
                    let at = frame.base.view as usize + usize::from(to);
                    *self.space.memory.stack.views.get_mut(at).ok_or(Fault::INTERPRETER)? = view;
                    nums = frame!();
                }
                Op::Load { to, place, lane } => {
                    let place = self.located(frame.base, place)?;
                    let value = self.space.memory.num(place, u32::from(lane))?;
                    nums = frame!();
                    set!(to, value);
                }
                Op::Store { place, lane, from } => {
                    let value = get!(from);
                    let place = self.located(frame.base, place)?;
                    self.space.memory.set_num(place, u32::from(lane), value)?;
                    nums = frame!();
                }
                Op::LoadText { to, place } => {
                    let text = *self.space.memory.text(self.located(frame.base, place)?)?;
                    self.set_text(frame.base, to, text)?;
                    nums = frame!();
                }
                Op::StoreText { place, from } => {
                    let (place, text) = (self.located(frame.base, place)?, *self.text(frame.base, from)?);
                    self.space.memory.set_text(place, text)?;
                    nums = frame!();
                }

                Op::Copy { site } => {
                    let site = program.copies.get(site as usize).ok_or(Fault::INTERPRETER)?;
                    let (from, to) = self.places(frame, site.from, site.to)?;
                    self.space.memory.copy(&site.kind, from, to)?;
                    nums = frame!();
                }
                Op::Compare { to, site } => {
                    let site = program.copies.get(site as usize).ok_or(Fault::INTERPRETER)?;
                    let (a, b) = self.places(frame, site.from, site.to)?;
                    let equal = self.space.memory.equal(&site.kind, a, b)?;
                    nums = frame!();
                    set!(to, truth!(equal));
                }
                Op::Instruction { site } => {
                    let site = program.instructions.get(site as usize).ok_or(Fault::INTERPRETER)?;
                    if let Some(stop) = self.instruction(thread, image, frame, site)? {
                        let again = matches!(stop, Stop::Waits);
                        leave!(next - usize::from(again), Leave::Turn(stop));
                    }
                    nums = frame!();
                }
                Op::Call { site } => {
                    let site = program.calls.get(site as usize).ok_or(Fault::INTERPRETER)?;
                    thread.next = u32::try_from(next).unwrap_or(u32::MAX);
                    change!(self.call(thread, image, program, frame, site)?);
                }
                Op::Return => change!(self.end_program(thread, frame)),
                Op::CreateTask { site } => {
                    let site = program.tasks.get(site as usize).ok_or(Fault::INTERPRETER)?;
                    self.ports.origin(self.origin(self.now(), frame, thread.line));
                    self.create_task(image, frame, site)?;
                    nums = frame!();
                }

                Op::WaitUntil { condition, retry } => {
                    if get!(condition) == 0.0 {
                        thread.wait = Some(Wait::default());
                        leave!(retry, Leave::Turn(Stop::Waits));
                    }
                }
                Op::Watch { to, condition, seconds, retry } => {
                    let (holds, seconds) = (get!(condition) != 0.0, get!(seconds));
                    let answer = self.watch(thread, holds, seconds);
                    nums = frame!();
                    match answer {
                        Some(answer) => set!(to, truth!(answer)),
                        None => leave!(retry, Leave::Turn(Stop::Waits)),
                    }
                }

                Op::ForTest { counter, limit, exit } => {
                    if is_beyond(get!(counter), get!(limit), get!(limit + 1)) {
                        next = exit as usize;
                    }
                }
                Op::ForNext { counter, limit, body } => {
                    if self.budget == 0 {
                        leave!(next - 1, Leave::Turn(Stop::Budget));
                    }
                    self.budget -= 1;
                    thread.line = u32::try_from(next - 1).unwrap_or(u32::MAX);
                    let step = get!(limit + 1);
                    let counted = get!(counter) + step;
                    set!(counter, counted);
                    if !is_beyond(counted, get!(limit), step) {
                        next = body as usize;
                    }
                }
            }
        }
        Err(Fault::INTERPRETER)
    }

    fn scope(&self, frame: Frame) -> Result<Scope<'_>> {
        Ok(Scope { memory: &self.space.memory, instance: self.instance(frame.instance)?, base: frame.base })
    }

    fn text(&self, base: Base, register: Register) -> Result<&Text> {
        let at = base.text as usize + usize::from(register);
        self.space.memory.stack.texts.get(at).ok_or(Fault::INTERPRETER)
    }

    fn set_text(&mut self, base: Base, register: Register, text: Text) -> Result<()> {
        let at = base.text as usize + usize::from(register);
        *self.space.memory.stack.texts.get_mut(at).ok_or(Fault::INTERPRETER)? = text;
        Ok(())
    }

    fn located(&self, base: Base, register: Register) -> Result<Place> {
        let at = base.place as usize + usize::from(register);
        self.space.memory.stack.places.get(at).copied().ok_or(Fault::INTERPRETER)
    }

    fn set_place(&mut self, base: Base, register: Register, place: Place) -> Result<()> {
        let at = base.place as usize + usize::from(register);
        *self.space.memory.stack.places.get_mut(at).ok_or(Fault::INTERPRETER)? = place;
        Ok(())
    }

    fn places(&self, frame: Frame, from: Operand, to: Operand) -> Result<(Place, Place)> {
        let scope = self.scope(frame)?;
        Ok((scope.place(from)?, scope.place(to)?))
    }

    /// Executes an instruction; `Some` if the turn ends with it.
    fn instruction(
        &mut self,
        thread: &mut Thread,
        image: &Image,
        frame: Frame,
        site: &InstructionSite,
    ) -> Result<Option<Stop>> {
        let now = self.now();
        self.ports.origin(self.origin(now, frame, thread.line));
        let Some(Handler(run)) = site.run else {
            self.ports.lacking(&site.name);
            return Ok(Some(Stop::Lacking));
        };
        let mut arguments = std::mem::take(&mut self.arguments);
        let scope = self.scope(frame)?;
        arguments.clear();
        for argument in &site.arguments {
            arguments.push(scope.argument(argument)?);
        }
        let result = site.result.map(|operand| scope.place(operand)).transpose()?;
        let mut services = Services {
            roster: self.roster,
            instances: &mut self.space.instances,
            changes: Changes::new(),
            request: None,
            owner: frame.instance,
        };
        let reach: (&mut Memory, &mut dyn Ports, &mut dyn Tasks) = (&mut self.space.memory, self.ports, &mut services);
        let mut call = Call::new(reach, (now, thread.waiting), (image.version, image.unit), &arguments, result);
        let flow = run(&mut call)?;
        self.reads_clock |= call.reads_clock;
        self.arguments = arguments;
        let Services { changes, request, .. } = services;
        changes.iter().for_each(|(task, name, change, at)| self.ports.task(*task, name, *change, *at));
        if !changes.is_empty() {
            self.end_with_turn();
        }
        if let Some(request) = request {
            let code = self.fulfil(frame.instance, request);
            result.map_or(Ok(()), |place| self.space.memory.set_num(place, 0, code))?;
        }
        match flow {
            Flow::Done(()) => thread.waiting = None,
            Flow::Wait(wait) => {
                thread.waiting = Some(Waiting::then(thread.waiting, wait, now));
                thread.wait = Some(wait);
                return Ok(Some(Stop::Waits));
            }
        }
        Ok(self.is_stopped().then_some(Stop::Halted))
    }

    pub(crate) fn origin(&self, time: Time, frame: Frame, line: u32) -> Origin {
        let at = CodePlace { instance: frame.instance.0, program: frame.program, line };
        Origin { time, task: self.task, at }
    }

    /// The task has halted or killed itself.
    fn is_stopped(&self) -> bool {
        let at = self.roster.position(self.task).and_then(|at| self.roster.tasks.get(at));
        at.is_some_and(|task| task.state != TaskState::Running)
    }

    /// `watch`: its answer, or that the task waits (5.10). Instructions in its condition have waits of their own.
    fn watch(&mut self, thread: &mut Thread, holds: bool, seconds: f64) -> Option<bool> {
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

    fn call(
        &mut self,
        thread: &mut Thread,
        image: &Arc<Image>,
        caller: &Program,
        frame: Frame,
        site: &CallSite,
    ) -> Result<Leave> {
        let base = behind(frame.base, caller);
        let (instance, number) = self.resolve(frame.instance, site.program)?;
        let other = (instance != frame.instance).then(|| self.instance(instance)).transpose()?;
        let other = other.map(|other| Arc::clone(&other.image));
        let callee = other.as_ref().unwrap_or(image).programs.get(usize::from(number)).ok_or(Fault::INTERPRETER)?;
        enter(&mut self.space.memory, callee, base, self.stack_size)?;
        for (param, argument) in callee.params.iter().zip(&site.arguments) {
            let passed = match (param.passing, *argument) {
                (Passing::Value(BaseType::Num | BaseType::Bool, to), ArgumentSite::Value(Operand::Frame(from), _)) => {
                    pass_number(&mut self.space.memory.stack.nums, frame.base.num + from.num, base.num + to.num)
                }
                _ => self.given(frame, argument).and_then(|given| pass(&mut self.space.memory, base, param, given)),
            };
            passed.inspect_err(|_| leave(&mut self.space.memory, base))?;
        }
        thread.frames.push(Frame { instance, program: number, back: thread.next, back_line: thread.line, base });
        thread.next = 0;
        Ok(if instance == frame.instance { Leave::Program } else { Leave::Instance })
    }

    #[inline]
    fn given(&self, frame: Frame, argument: &ArgumentSite) -> Result<Given> {
        self.scope(frame)?.given(argument)
    }

    pub(crate) fn resolve(&self, from: InstanceId, program: ProgramRef) -> Result<(InstanceId, u16)> {
        match program {
            ProgramRef::Own(number) => Ok((from, number)),
            ProgramRef::Import(number) => match self.instance(from)?.imports.get(usize::from(number)) {
                Some(Some(Imported::Program(instance, number))) => Ok((*instance, *number)),
                _ => Err(Fault::LIBRARY_ITEM_MISSING),
            },
        }
    }

    fn end_program(&mut self, thread: &mut Thread, frame: Frame) -> Leave {
        leave(&mut self.space.memory, frame.base);
        thread.frames.pop();
        (thread.next, thread.line) = (frame.back, frame.back_line);
        match thread.frames.last() {
            None => Leave::Turn(Stop::Ended),
            Some(caller) if caller.instance == frame.instance => Leave::Program,
            Some(_) => Leave::Instance,
        }
    }
}

/// The program that the task is in.
fn innermost<'i>(thread: &Thread, image: &'i Image) -> Result<(Frame, &'i Program)> {
    let frame = *thread.frames.last().ok_or(Fault::INTERPRETER)?;
    let program = image.programs.get(usize::from(frame.program)).ok_or(Fault::INTERPRETER)?;
    Ok((frame, program))
}

/// Where the numbers of a frame are among those of the stack.
fn numbers(frame: Frame, program: &Program) -> std::ops::Range<usize> {
    let start = frame.base.num as usize;
    start..start + program.frame.lanes.num as usize
}
