//! Guards of stop marks: conditions that the interpreter evaluates within the turn, and hits that it counts, so that a
//! task passes a stop mark without a stop if no condition is true or the hit is only counted.
//!
//! A guard only reads numbers and strings of global data and of the stack frame, also in arrays and fields, and has no
//! side effects except on [hit counters](HitCounters). A condition that would cause a run-time error stops the task, and
//! the caller evaluates it in the general way.

use std::sync::Arc;

use val3_bytecode::{
    ArgumentSite, ContainerKind, ContainerRef, Fragment, Image, Op, Operand, Program, Register, Storage, TextOperand,
    TextSource,
};
use val3_lang::memory::{Lanes, Memory, Place, StoreId, View};
use val3_lang::values::Text;

use crate::arithmetic::{remainder, truth};
use crate::hit_counters::{CounterId, HitCounters};
use crate::operands::{OperandContext, place_of, view_of};
use crate::{Frame, Instance, InstanceId, Space};

/// Largest number of numbers in the frame of a condition.
const REGISTERS: usize = 16;

/// Largest number of places, and of views, that a condition looks up.
const LOOKUPS: usize = 8;

/// Guard of a stop mark, at which most arrivals are no stop.
#[derive(Debug, Clone)]
pub struct StopGuard {
    place: GuardedOp,
    /// Image in memory when the guard was created. The guard has no effect in other images.
    image: Arc<Image>,
    reasons: Vec<GuardedReason>,
}

/// Reason for a stop, for [`StopGuard::new`].
#[derive(Debug, Clone, Copy)]
pub struct StopReason<'a> {
    /// Name of the only task that stops; `None` for all tasks.
    pub task: Option<&'a str>,
    /// Condition of the stop.
    pub condition: Option<&'a Fragment>,
    /// Counter of the hits that are no stops; `None` if each hit is a stop.
    pub counter: Option<CounterId>,
}

/// Reason for a stop that the interpreter can exclude.
#[derive(Debug, Clone)]
struct GuardedReason {
    task: Option<String>,
    condition: Option<PureCondition>,
    counter: Option<CounterId>,
}

/// Effect of a task's arrival at a stop mark on a reason.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum ArrivalEffect {
    /// The reason is for another task, or its condition does not hold.
    None,
    /// A hit that is only counted.
    Counted(CounterId),
    Stop,
}

/// Operation with a stop mark.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct GuardedOp {
    /// Application or library.
    pub instance: InstanceId,
    /// Program number.
    pub program: u16,
    /// Index of the operation in the program's code.
    pub op: u32,
}

impl GuardedOp {
    /// Whether a frame executes the program of this operation, and `op` is the operation's number.
    fn is_at(self, frame: &Frame, op: usize) -> bool {
        self.op as usize == op && self.program == frame.program && self.instance == frame.instance
    }
}

/// Condition whose operations only read values and compute with numbers.
#[derive(Debug, Clone)]
struct PureCondition {
    program: Arc<Program>,
    /// Location of the result, after the operation with index `end`.
    result: ConditionResult,
    end: u32,
    /// Variables of the guarded program to which the first place registers refer.
    places: Vec<Storage>,
    /// Variables of the guarded program to which the first view registers refer.
    views: Vec<Storage>,
}

/// Location of a condition's result.
#[derive(Debug, Clone, Copy)]
enum ConditionResult {
    Register(Register),
    Place(Register, Lanes),
    First(ContainerRef),
}

/// Registers of a condition in evaluation.
struct Registers<'a> {
    condition: &'a PureCondition,
    memory: &'a Memory,
    scope: OperandContext<'a>,
    nums: [f64; REGISTERS],
    /// Places after the variables.
    places: [Option<Place>; LOOKUPS],
    /// Views after the variables.
    views: [Option<View>; LOOKUPS],
}

impl StopGuard {
    /// Creates the guard of a stop mark at which tasks stop only for one of the reasons. Returns `None` if the operation
    /// does not exist, if a condition requires more, or if each arrival of every task is a stop.
    pub fn new<'f>(space: &Space, place: GuardedOp, reasons: impl IntoIterator<Item = StopReason<'f>>) -> Option<Self> {
        let image = Arc::clone(&space.instance(place.instance)?.image);
        let program = image.programs.get(usize::from(place.program))?;
        let reasons = reasons.into_iter().map(|reason| GuardedReason::new(program, reason));
        let reasons = reasons.collect::<Option<_>>()?;
        Some(Self { place, image, reasons })
    }

    /// Whether the task with this name does not stop for any reason. The hits that are only counted are then added.
    fn passes(
        &self,
        memory: &Memory,
        counters: &mut HitCounters,
        instance: &Instance,
        frame: &Frame,
        task: &str,
    ) -> bool {
        let mut counted = Vec::new();
        for reason in &self.reasons {
            match reason.effect(memory, instance, frame, task) {
                ArrivalEffect::Counted(counter) if counters.has_pass(counter) => counted.push(counter),
                ArrivalEffect::Counted(_) | ArrivalEffect::Stop => return false,
                ArrivalEffect::None => {}
            }
        }
        counted.into_iter().for_each(|counter| counters.pass(counter));
        true
    }
}

impl GuardedReason {
    /// Returns the reason for the variables of `program`; `None` if the interpreter cannot exclude it.
    fn new(program: &Program, StopReason { task, condition, counter }: StopReason<'_>) -> Option<Self> {
        let condition = condition.map(|condition| PureCondition::new(program, condition));
        match (task, condition, counter) {
            (None, None, None) | (_, Some(None), _) => None,
            (task, condition, counter) => {
                Some(Self { task: task.map(str::to_owned), condition: condition.flatten(), counter })
            }
        }
    }

    fn effect(&self, memory: &Memory, instance: &Instance, frame: &Frame, task: &str) -> ArrivalEffect {
        if self.task.as_ref().is_some_and(|name| name != task) {
            return ArrivalEffect::None;
        }
        let holds = match self.condition.as_ref().map(|condition| condition.value(memory, instance, frame)) {
            Some(Some(value)) => value != 0.0,
            // The caller reports the run-time error.
            Some(None) => return ArrivalEffect::Stop,
            None => true,
        };
        match self.counter {
            _ if !holds => ArrivalEffect::None,
            Some(counter) => ArrivalEffect::Counted(counter),
            None => ArrivalEffect::Stop,
        }
    }
}

impl Space {
    /// Whether the task with this name passes a stop mark because the mark's guard excludes a stop.
    pub(crate) fn passes_stop(&mut self, instance: &Instance, frame: &Frame, op: usize, task: &str) -> bool {
        self.guards.iter().find(|guard| guard.place.is_at(frame, op)).is_some_and(|guard| {
            Arc::ptr_eq(&guard.image, &instance.image)
                && guard.passes(&self.memory, &mut self.hit_counters, instance, frame, task)
        })
    }
}

impl ConditionResult {
    fn of(site: &ArgumentSite) -> Option<Self> {
        match *site {
            ArgumentSite::Value(Operand::Frame(lanes), _) => Register::try_from(lanes.num).ok().map(Self::Register),
            ArgumentSite::Value(Operand::Place(place, lanes), _) => Some(Self::Place(place, lanes)),
            ArgumentSite::Value(Operand::First(container, lanes), _) if lanes == Lanes::default() => {
                Some(Self::First(container))
            }
            ArgumentSite::View(container, None) => Some(Self::First(container)),
            _ => None,
        }
    }
}

impl PureCondition {
    /// Returns the condition for the variables of `program`; `None` if an operation is not supported.
    fn new(program: &Program, condition: &Fragment) -> Option<Self> {
        let result = ConditionResult::of(&condition.value.as_ref()?.site)?;
        let (code, end) = (&condition.program, condition.end());
        let operations = code.code.get(..end as usize)?;
        let is_small = code.frame.lanes.num as usize <= REGISTERS;
        (is_small && operations.iter().all(|step| is_supported(step.op))).then_some(())?;
        let (mut places, mut views) = (Vec::new(), Vec::new());
        for (reference, variable) in code.variables.iter().zip(&program.variables) {
            let (list, number) = match reference.storage {
                Storage::Place(number) => (&mut places, number),
                Storage::View(number) => (&mut views, number),
                Storage::Value(_) | Storage::Part(_) => return None,
            };
            (usize::from(number) == list.len()).then_some(())?;
            list.push(variable.storage);
        }
        Some(Self { program: Arc::clone(code), result, end, places, views })
    }

    /// Returns the value in a stack frame; `None` instead of a run-time error.
    fn value(&self, memory: &Memory, instance: &Instance, frame: &Frame) -> Option<f64> {
        let mut registers = self.registers(memory, instance, frame)?;
        let mut next = 0;
        while next < self.end as usize {
            let op = self.program.code.get(next)?.op;
            next += 1;
            if let Some(to) = registers.jump(op)? {
                // Expressions have no loops.
                next = (to as usize).max(next);
            } else {
                registers.execute(op)?;
            }
        }
        match self.result {
            ConditionResult::Register(number) => register(&registers.nums, number),
            ConditionResult::Place(place, lanes) => memory.num(registers.place(place)?.after(lanes), 0).ok(),
            ConditionResult::First(container) => memory.stores.first(registers.view(container)?, 0).copied(),
        }
    }

    fn registers<'a>(&'a self, memory: &'a Memory, instance: &'a Instance, frame: &Frame) -> Option<Registers<'a>> {
        let scope = OperandContext { instance, program: &self.program, base: frame.base };
        let mut nums = [0.0; REGISTERS];
        nums.get_mut(..self.program.nums.len())?.copy_from_slice(&self.program.nums);
        let (places, views) = ([None; LOOKUPS], [None; LOOKUPS]);
        Some(Registers { condition: self, memory, scope, nums, places, views })
    }
}

impl Registers<'_> {
    /// Executes an operation that does not jump. `None` is a run-time error.
    fn execute(&mut self, op: Op) -> Option<()> {
        let stores = &self.memory.stores;
        let (to, value) = match op {
            Op::LoadFirst { to, container, lane } => (to, *stores.first(self.view(container)?, lane)?),
            Op::LoadElement { to, container, index } => {
                (to, *stores.element(self.view(container)?, register(&self.nums, index)?)?)
            }
            Op::Load { to, place, lane } => (to, self.memory.num(self.place(place)?, u32::from(lane)).ok()?),
            Op::TextEqual { to, a, b } => (to, truth(self.are_equal(a, b)?)),
            Op::LocateFirst { to, container } => {
                let place = stores.first_place(self.view(container)?)?;
                return self.set_place(to, place);
            }
            Op::Locate { to, container, index } => {
                let place = stores.element_place(self.view(container)?, register(&self.nums, index)?)?;
                return self.set_place(to, place);
            }
            Op::FirstField { to, container, field } => {
                let store = stores.field(self.view(container)?, field)?;
                return self.set_view(to, store);
            }
            Op::ElementField { to, container, index, field } => {
                let at = register(&self.nums, index)?;
                let store = stores.element_field(self.view(container)?, at, field)?;
                return self.set_view(to, store);
            }
            Op::Field { to, place, field } => {
                let store = self.memory.part(self.place(place)?, u32::from(field)).ok()?;
                return self.set_view(to, store);
            }
            _ => match computed(op, &self.nums)? {
                Some(computed) => computed,
                None => return Some(()),
            },
        };
        *self.nums.get_mut(usize::from(to))? = value;
        Some(())
    }

    /// Returns the target if the operation jumps. The outer `None` is a run-time error.
    #[allow(clippy::option_option, reason = "the outer option is the error")]
    fn jump(&self, op: Op) -> Option<Option<u32>> {
        match op {
            Op::IfTextEqual { a, b, to } => Some(self.are_equal(a, b)?.then_some(to)),
            Op::UnlessTextEqual { a, b, to } => Some((!self.are_equal(a, b)?).then_some(to)),
            op => jump(op, &self.nums),
        }
    }

    fn are_equal(&self, a: TextOperand, b: TextOperand) -> Option<bool> {
        Some(self.text(a)? == self.text(b)?)
    }

    fn text(&self, operand: TextOperand) -> Option<&Text> {
        match operand.source() {
            TextSource::Constant(number) => self.scope.program.texts.get(usize::from(number)),
            TextSource::First(kind) => self.memory.stores.first_text(self.view_of(kind)?),
            TextSource::Place(place) => self.memory.text(self.place(place)?).ok(),
            TextSource::Register(_) => None,
        }
    }

    fn place(&self, number: Register) -> Option<Place> {
        let number = usize::from(number);
        match self.condition.places.get(number) {
            Some(variable) => place_of(self.memory, &self.scope.base, *variable),
            None => *self.places.get(number - self.condition.places.len())?,
        }
    }

    fn view(&self, container: ContainerRef) -> Option<View> {
        self.view_of(container.kind())
    }

    fn view_of(&self, kind: ContainerKind) -> Option<View> {
        let ContainerKind::View(number) = kind else { return self.scope.view_of(self.memory, kind).ok() };
        let number = usize::from(number);
        match self.condition.views.get(number) {
            Some(variable) => view_of(self.memory, &self.scope.base, *variable),
            None => *self.views.get(number - self.condition.views.len())?,
        }
    }

    fn set_place(&mut self, number: Register, place: Place) -> Option<()> {
        let number = usize::from(number).checked_sub(self.condition.places.len())?;
        *self.places.get_mut(number)? = Some(place);
        Some(())
    }

    fn set_view(&mut self, number: Register, store: StoreId) -> Option<()> {
        let number = usize::from(number).checked_sub(self.condition.views.len())?;
        *self.views.get_mut(number)? = Some(View::whole(store));
        Some(())
    }
}

/// Whether a condition may contain the operation.
fn is_supported(op: Op) -> bool {
    match op {
        Op::LoadFirst { container, .. }
        | Op::LoadElement { container, .. }
        | Op::LocateFirst { container, .. }
        | Op::Locate { container, .. }
        | Op::FirstField { container, .. }
        | Op::ElementField { container, .. } => is_known(container.kind()),
        Op::TextEqual { a, b, .. } | Op::IfTextEqual { a, b, .. } | Op::UnlessTextEqual { a, b, .. } => {
            is_readable_text(a) && is_readable_text(b)
        }
        Op::Load { .. } | Op::Field { .. } => true,
        op => is_computation(op),
    }
}

/// Whether a condition may read the string.
fn is_readable_text(text: TextOperand) -> bool {
    match text.source() {
        TextSource::First(kind) => is_known(kind),
        TextSource::Place(_) | TextSource::Constant(_) => true,
        TextSource::Register(_) => false,
    }
}

/// Whether a condition may read the container. Conditions have no containers of their own.
fn is_known(kind: ContainerKind) -> bool {
    !matches!(kind, ContainerKind::Part(_))
}

fn is_computation(op: Op) -> bool {
    matches!(
        op,
        Op::Line
            | Op::Jump { .. }
            | Op::JumpUnless { .. }
            | Op::JumpIf { .. }
            | Op::IfLess { .. }
            | Op::IfLessEqual { .. }
            | Op::UnlessLess { .. }
            | Op::UnlessLessEqual { .. }
            | Op::UnlessEqual { .. }
            | Op::IfEqual { .. }
            | Op::Move { .. }
            | Op::Add { .. }
            | Op::Subtract { .. }
            | Op::Multiply { .. }
            | Op::Divide { .. }
            | Op::Remainder { .. }
            | Op::Negate { .. }
            | Op::Not { .. }
            | Op::Less { .. }
            | Op::LessEqual { .. }
            | Op::Equal { .. }
            | Op::NotEqual { .. }
            | Op::Function { .. }
    )
}

fn register(nums: &[f64; REGISTERS], register: Register) -> Option<f64> {
    nums.get(usize::from(register)).copied()
}

/// Returns the target if the operation jumps. The outer `None` is an invalid register.
#[allow(clippy::neg_cmp_op_on_partial_ord, reason = "a comparison with what is no number does not hold")]
#[allow(clippy::option_option, reason = "the outer option is the error")]
fn jump(op: Op, nums: &[f64; REGISTERS]) -> Option<Option<u32>> {
    let get = |number| register(nums, number);
    let (jumps, to) = match op {
        Op::Jump { to } => (true, to),
        Op::JumpUnless { condition, to } => (get(condition)? == 0.0, to),
        Op::JumpIf { condition, to } => (get(condition)? != 0.0, to),
        Op::IfLess { a, b, to } => (get(a)? < get(b)?, to),
        Op::IfLessEqual { a, b, to } => (get(a)? <= get(b)?, to),
        Op::UnlessLess { a, b, to } => (!(get(a)? < get(b)?), to),
        Op::UnlessLessEqual { a, b, to } => (!(get(a)? <= get(b)?), to),
        Op::UnlessEqual { a, b, to } => (get(a)? != get(b)?, to),
        Op::IfEqual { a, b, to } => (get(a)? == get(b)?, to),
        _ => return Some(None),
    };
    Some(jumps.then_some(to))
}

/// Returns the register and the number that the operation writes, if any. The outer `None` is a run-time error or an
/// operation that is no [computation](is_computation).
#[allow(clippy::option_option, reason = "the outer option is the error")]
fn computed(op: Op, nums: &[f64; REGISTERS]) -> Option<Option<(Register, f64)>> {
    let get = |number| register(nums, number);
    Some(Some(match op {
        Op::Move { to, from } => (to, get(from)?),
        Op::Add { to, a, b } => (to, get(a)? + get(b)?),
        Op::Subtract { to, a, b } => (to, get(a)? - get(b)?),
        Op::Multiply { to, a, b } => (to, get(a)? * get(b)?),
        Op::Divide { to, a, b } => {
            let divisor = get(b).filter(|divisor| *divisor != 0.0)?;
            (to, get(a)? / divisor)
        }
        Op::Remainder { to, a, b } => (to, remainder(get(a)?, get(b)?).ok()?),
        Op::Negate { to, a } => (to, -get(a)?),
        Op::Not { to, a } => (to, truth(get(a)? == 0.0)),
        Op::Less { to, a, b } => (to, truth(get(a)? < get(b)?)),
        Op::LessEqual { to, a, b } => (to, truth(get(a)? <= get(b)?)),
        Op::Equal { to, a, b } => (to, truth(get(a)? == get(b)?)),
        Op::NotEqual { to, a, b } => (to, truth(get(a)? != get(b)?)),
        Op::Function { function, to, a, b, c } => (to, function.compute([get(a)?, get(b)?, get(c)?]).ok()?),
        op if is_computation(op) => return Some(None),
        _ => return None,
    }))
}
