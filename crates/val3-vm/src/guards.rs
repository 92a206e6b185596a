//! Guards of stop marks: conditions that the interpreter evaluates within the turn, so that a task passes a stop mark
//! without a stop if no condition is true.
//!
//! A guard only reads numbers of global data and of the stack frame, and has no side effects. A condition that would
//! cause a run-time error stops the task, and the caller evaluates it in the general way.

use std::sync::Arc;

use val3_bytecode::{ArgumentSite, ContainerKind, Fragment, Image, Op, Operand, Program, Register, Storage};
use val3_lang::memory::Memory;

use crate::arithmetic::{remainder, truth};
use crate::operands::{OperandContext, located, on_frame};
use crate::{Frame, Instance, InstanceId, Space};

/// Largest number of numbers in the frame of a condition.
const REGISTERS: usize = 16;

/// Guard of a stop mark. All conditions are false at most arrivals.
#[derive(Debug, Clone)]
pub struct StopGuard {
    place: GuardedOp,
    /// Image in memory when the guard was created. The guard has no effect in other images.
    image: Arc<Image>,
    conditions: Vec<NumberCondition>,
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

/// Condition whose operations compute with numbers only.
#[derive(Debug, Clone)]
struct NumberCondition {
    program: Arc<Program>,
    /// Register of the result, after the operation with index `end`.
    result: Register,
    end: u32,
    /// Variable of the guarded program for each place register.
    places: Vec<Storage>,
}

impl StopGuard {
    /// Creates the guard of a stop mark at which tasks stop only if one of the conditions is true. Returns `None` if
    /// the operation does not exist or a condition requires more than numbers.
    pub fn new<'f>(
        space: &Space,
        place: GuardedOp,
        conditions: impl IntoIterator<Item = &'f Fragment>,
    ) -> Option<Self> {
        let image = Arc::clone(&space.instance(place.instance)?.image);
        let program = image.programs.get(usize::from(place.program))?;
        let conditions = conditions.into_iter().map(|condition| NumberCondition::new(program, condition));
        let conditions = conditions.collect::<Option<_>>()?;
        Some(Self { place, image, conditions })
    }

    /// Whether no condition is true.
    fn excludes(&self, memory: &Memory, instance: &Instance, frame: &Frame) -> bool {
        self.conditions.iter().all(|condition| condition.value(memory, instance, frame) == Some(0.0))
    }
}

impl Space {
    /// Whether a task passes a stop mark because the mark's guard excludes a stop.
    pub(crate) fn passes_stop(&self, instance: &Instance, frame: &Frame, op: usize) -> bool {
        let here = |guard: &&StopGuard| {
            let GuardedOp { instance, program, op: guarded } = guard.place;
            guarded as usize == op && program == frame.program && instance == frame.instance
        };
        self.guards.iter().find(here).is_some_and(|guard| {
            Arc::ptr_eq(&guard.image, &instance.image) && guard.excludes(&self.memory, instance, frame)
        })
    }
}

impl NumberCondition {
    /// Returns the condition for the variables of `program`; `None` if an operation requires more than numbers.
    fn new(program: &Program, condition: &Fragment) -> Option<Self> {
        let ArgumentSite::Value(Operand::Frame(lanes), _) = condition.value.as_ref()?.site else { return None };
        let code = &condition.program;
        let end = condition.end();
        let is_supported = code.frame.lanes.num as usize <= REGISTERS
            && code.code.get(..end as usize)?.iter().all(|step| is_number_operation(step.op));
        is_supported.then_some(())?;
        let mut places = Vec::new();
        for (reference, variable) in code.variables.iter().zip(&program.variables) {
            if let Storage::Place(number) = reference.storage {
                (usize::from(number) == places.len()).then_some(())?;
                places.push(variable.storage);
            }
        }
        Some(Self { program: Arc::clone(code), result: Register::try_from(lanes.num).ok()?, end, places })
    }

    /// Returns the value in a stack frame; `None` instead of a run-time error.
    fn value(&self, memory: &Memory, instance: &Instance, frame: &Frame) -> Option<f64> {
        let mut nums = [0.0; REGISTERS];
        nums.get_mut(..self.program.nums.len())?.copy_from_slice(&self.program.nums);
        let scope = OperandContext { instance, program: &self.program, base: frame.base };
        let mut next = 0;
        while next < self.end as usize {
            let op = self.program.code.get(next)?.op;
            next += 1;
            if let Some(to) = jump(op, &nums)? {
                // Expressions have no loops.
                next = (to as usize).max(next);
                continue;
            }
            let (to, value) = match op {
                Op::LoadFirst { to, container, lane } => {
                    (to, *memory.stores.first(scope.view(memory, container).ok()?, lane)?)
                }
                Op::LoadElement { to, container, index } => {
                    let view = scope.view(memory, container).ok()?;
                    (to, *memory.stores.element(view, register(&nums, index)?)?)
                }
                Op::Load { to, place, lane } => (to, self.variable(memory, frame, place, lane)?),
                _ => match computed(op, &nums)? {
                    Some(computed) => computed,
                    None => continue,
                },
            };
            *nums.get_mut(usize::from(to))? = value;
        }
        register(&nums, self.result)
    }

    /// Returns a number of a parameter or local.
    fn variable(&self, memory: &Memory, frame: &Frame, place: Register, lane: u16) -> Option<f64> {
        let place = match *self.places.get(usize::from(place))? {
            Storage::Value(lanes) => on_frame(&frame.base, lanes),
            Storage::Place(register) => located(memory, &frame.base, register).ok()?,
            Storage::Part(_) | Storage::View(_) => return None,
        };
        memory.num(place, u32::from(lane)).ok()
    }
}

/// Whether a condition may contain the operation.
fn is_number_operation(op: Op) -> bool {
    match op {
        Op::LoadFirst { container, .. } | Op::LoadElement { container, .. } => {
            matches!(container.kind(), ContainerKind::Data(_) | ContainerKind::Import(_))
        }
        Op::Load { .. } => true,
        op => jump(op, &[0.0; REGISTERS]).is_some() && is_computation(op),
    }
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
