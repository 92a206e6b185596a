//! Numbers of a frame that only exist on the way through an expression.
//!
//! Such a register has no name, and whatever reads it, a step before has written it, with no way in between from
//! elsewhere. So it is nothing to a loop or to the frame as a whole: only where the code stops on the way between both,
//! the interpreter has to find it.

use std::collections::BTreeSet;
use std::ops::Range;

use val3_bytecode::{ArgumentSite, Image, Op, Operand, Pass, Program, Register, SlotSite, Storage};
use val3_lang::memory::Kind;

use crate::calls::plain_call;
use crate::lanes::{Lane, Lanes, parameters, referred};
use crate::operands::{registers, written};

/// The temporary registers of a program.
#[derive(Debug)]
pub(crate) struct Temporaries {
    registers: BTreeSet<Register>,
    /// Steps to which jumps lead.
    targets: BTreeSet<u32>,
}

impl Temporaries {
    pub(crate) fn of(program: &Program, image: &Image, lanes: &Lanes) -> Self {
        let targets = program.code.iter().filter_map(|step| target(step.op)).collect();
        let others: Vec<Range<u32>> = lasting(program, image).collect();
        let lasts = |register: &Register| others.iter().any(|range| range.contains(&u32::from(*register)));
        let variables = lanes.iter().filter(|(_, lane)| matches!(lane, Lane::Variable(_)));
        let registers = variables.map(|(register, _)| register).filter(|register| !lasts(register)).collect();
        let mut found = Self { registers, targets };
        let mut known = BTreeSet::new();
        for (step, number) in program.code.iter().zip(0..) {
            if found.targets.contains(&number) {
                known.clear();
            }
            for register in read(step.op, program).filter(|register| !known.contains(register)) {
                found.registers.remove(&register);
            }
            known.extend(written(step.op));
        }
        found
    }

    pub(crate) fn has(&self, register: Register) -> bool {
        self.registers.contains(&register)
    }

    /// Those that the steps from one on read before they write them.
    pub(crate) fn at(&self, step: u32, program: &Program) -> BTreeSet<Register> {
        let (mut wanted, mut known) = (BTreeSet::new(), BTreeSet::new());
        for (next, number) in program.code.iter().zip(0..).skip(step as usize) {
            if number > step && self.targets.contains(&number) {
                break;
            }
            let read = read(next.op, program).filter(|register| self.has(*register) && !known.contains(register));
            wanted.extend(read);
            known.extend(written(next.op));
        }
        wanted
    }
}

/// Where an operation may go on instead of at the next one, whoever does it.
fn target(mut op: Op) -> Option<u32> {
    op.target_mut().copied()
}

/// The registers that machine code reads for an operation, or the interpreter in its place.
fn read(op: Op, program: &Program) -> impl Iterator<Item = Register> {
    let counts = matches!(op, Op::ForNext { .. } | Op::ForNextUp { .. });
    // Before the others comes what is written.
    let skipped = usize::from(written(op).is_some() && !counts);
    let passed = plain_call(op, program).into_iter().flat_map(|(passes, _)| passes);
    let passed = passed.filter_map(|pass| match *pass {
        Pass::Number(from, _) => Some(from),
        Pass::Reference(..) => None,
    });
    registers(op).skip(skipped).chain(passed)
}

/// Registers that may be read at any time: what is passed on, what has a name, and what operations work on for which
/// there is no machine code.
fn lasting<'p>(program: &'p Program, image: &'p Image) -> impl Iterator<Item = Range<u32>> + 'p {
    let one = |register: u32| register..register + 1;
    let given = parameters(program).chain(referred(program, image)).map(one);
    let named = program.variables.iter().filter_map(|variable| match variable.storage {
        Storage::Value(lanes) => Some(lanes.num..lanes.num + variable.kind.size.num),
        _ => None,
    });
    let copied = program.copies.iter().flat_map(|site| [site.from, site.to].map(|value| within(value, &site.kind)));
    let tasks = program.tasks.iter();
    let rates = tasks.clone().map(move |site| one(site.rate.into()));
    let calls = program.calls.iter().filter(|site| site.passes.is_none()).chain(tasks.map(|site| &site.call));
    let arguments = calls.map(|site| &site.arguments).chain(program.instructions.iter().map(|site| &site.arguments));
    let others = program.code.iter().flat_map(|step| used_elsewhere(step.op));
    given.chain(named).chain(copied.flatten()).chain(rates).chain(arguments.flatten().flat_map(argument)).chain(others)
}

/// The registers of a value.
fn within(value: Operand, kind: &Kind) -> Option<Range<u32>> {
    match value {
        Operand::Frame(lanes) => Some(lanes.num..lanes.num + kind.size.num),
        Operand::Place(..) => None,
    }
}

/// The registers of an argument; from the first on all, where its type is not known here.
fn argument(argument: &ArgumentSite) -> Option<Range<u32>> {
    match *argument {
        ArgumentSite::Value(value, base) => within(value, &Kind::builtin(base, None)),
        ArgumentSite::UserValue(Operand::Frame(lanes)) => Some(lanes.num..u32::MAX),
        ArgumentSite::View(_, Some(index)) => Some(index.into()..u32::from(index) + 1),
        ArgumentSite::Slot(_, SlotSite::Index(first, count)) => Some(first.into()..u32::from(first) + u32::from(count)),
        _ => None,
    }
}

/// The registers that an operation reads for which there is never machine code.
fn used_elsewhere(op: Op) -> Option<Range<u32>> {
    match op {
        Op::Locate3 { i, .. } => Some(i.into()..u32::from(i) + 3),
        Op::Watch { condition, seconds, .. } => {
            Some(condition.min(seconds).into()..u32::from(condition.max(seconds)) + 1)
        }
        _ => None,
    }
}
