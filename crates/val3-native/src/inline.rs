//! Which calls become code of the function that makes them: those of short programs, and openings of others.

use std::iter;

use val3_bytecode::{Op, Program};

use crate::body::Surroundings;
use crate::calls::{Call, callee};
use crate::flow::target;
use crate::operands::registers;

/// Steps of a program, or of an opening, that is short.
const SHORT: usize = 24;

/// Levels at most.
const DEEPEST: u32 = 4;

/// Steps that calls may become in one function, and in all functions of a module: translating takes time.
const MOST_STEPS: (usize, usize) = (200, 2_000);

/// What becomes of a call.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Becomes {
    /// The call of the function.
    Function,
    /// The opening of the program, and the call of the function behind it.
    Opening(Opening),
    /// The code of the program.
    Code,
}

/// A test with which a program begins and by which it may return at once; before the test nothing has changed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Opening {
    /// The step with which it goes on where it does not.
    pub(crate) end: u32,
    /// The lines that begin before and with the test.
    pub(crate) lines: u32,
}

/// How far calls become code in the function of a program: not at all on level 0, openings alone on level 1, on each
/// further level the programs that are called as well, in which calls are one level lower.
pub(crate) fn levels(module: &Surroundings<'_>, program: &Program) -> u32 {
    let most = MOST_STEPS.0.min(MOST_STEPS.1 / module.programs.len().max(1));
    (1..=DEEPEST).take_while(|levels| steps(module, program, *levels) <= most).last().unwrap_or_default()
}

/// How many steps the calls become.
fn steps(module: &Surroundings<'_>, program: &Program, levels: u32) -> usize {
    let calls = program.code.iter().filter_map(|step| callee(module, program, step.op));
    let each = calls.map(|call| match call.becomes(levels) {
        Becomes::Function => 0,
        Becomes::Opening(Opening { end, .. }) => end as usize,
        Becomes::Code => call.callee.code.len() + steps(module, call.callee, levels.saturating_sub(1)),
    });
    each.sum()
}

/// A program with all whose code its calls become.
pub(crate) fn with_inlined<'m>(module: &'m Surroundings<'m>, program: &'m Program, levels: u32) -> Vec<&'m Program> {
    let calls = program.code.iter().filter_map(|step| callee(module, program, step.op));
    let within = calls.filter(|call| call.becomes(levels) == Becomes::Code).map(|call| call.callee);
    let all = within.flat_map(|callee| with_inlined(module, callee, levels.saturating_sub(1)));
    iter::once(program).chain(all).collect()
}

/// The bytes of the declared stack that a call takes at most, with all calls in the code that it becomes.
pub(crate) fn most_taken(module: &Surroundings<'_>, call: &Call<'_>, levels: u32) -> u32 {
    let is_code = call.becomes(levels) == Becomes::Code;
    let within = if is_code { call.callee.code.as_slice() } else { &[] };
    let calls = within.iter().filter_map(|step| callee(module, call.callee, step.op));
    let most = calls.map(|call| most_taken(module, &call, levels.saturating_sub(1))).max();
    call.callee.stack_bytes + most.unwrap_or_default()
}

impl Call<'_> {
    /// What becomes of the call on a level.
    pub(crate) fn becomes(&self, level: u32) -> Becomes {
        match (level, opening(self.callee)) {
            (2.., _) if is_short(self.callee) => Becomes::Code,
            (1.., Some(opening)) => Becomes::Opening(opening),
            _ => Becomes::Function,
        }
    }
}

/// A program without loops that has few steps.
fn is_short(program: &Program) -> bool {
    let mut steps = program.code.iter().zip(0..);
    program.code.len() <= SHORT && steps.all(|(step, number)| target(step.op).is_none_or(|to| to > number))
}

/// The opening of a program.
fn opening(program: &Program) -> Option<Opening> {
    let test = program.code.iter().position(|step| target(step.op).is_some())?;
    let op = program.code.get(test)?.op;
    let end = target(op).filter(|_| !matches!(op, Op::Jump { .. }))?;
    let steps = program.code.get(..end as usize).filter(|steps| steps.len() <= SHORT)?;
    let (before, within) = steps.split_at_checked(test + 1)?;
    let changes_nothing = before.iter().all(|step| target(step.op).is_some() || computes(step.op));
    let (last, way) = within.split_last()?;
    let returns = last.op == Op::Return
        && way.iter().all(|step| registers(step.op).next().is_some() && target(step.op).is_none());
    let lines = before.iter().filter(|step| step.line).count();
    (changes_nothing && returns).then_some(Opening { end, lines: u32::try_from(lines).ok()? })
}

/// An operation that writes a register and nothing else.
fn computes(op: Op) -> bool {
    let stores =
        matches!(op, Op::Store { .. } | Op::StoreFirst { .. } | Op::StoreElement { .. } | Op::StoreElement2 { .. });
    !stores && registers(op).next().is_some()
}
