//! What the variables of a program hold: numbers, or where that is enough, whole numbers or truth values.

use std::collections::{BTreeMap, BTreeSet};

use val3_bytecode::{Image, Op, Operand, Program, Register};
use val3_lang::memory::Kind;
use wasm_encoder::ValType;

use crate::bounds::{self, Bounds};
use crate::containers::Width;
use crate::lanes::{Lane, Lanes, number, parameters, referred};
use crate::operands::{container, index, written};

/// What a variable holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Sort {
    /// Any number.
    Number,
    /// A whole number of less than 2^53 either way.
    Whole,
    /// A truth value.
    Truth,
}

impl Sort {
    /// The type of its variables.
    pub(crate) fn kind(self) -> ValType {
        match self {
            Self::Number => ValType::F64,
            Self::Whole => ValType::I64,
            Self::Truth => ValType::I32,
        }
    }
}

/// What the variables of one program hold. Parameters, and what is passed by reference, are numbers.
#[derive(Debug)]
pub(crate) struct Sorts {
    whole: BTreeMap<Register, Bounds>,
    truths: BTreeSet<Register>,
}

impl Sorts {
    /// Supposes the best of all variables, and takes out those in which a step may put something else, until none is
    /// left. Of the whole numbers those stay which are indexes, or from which indexes are made.
    pub(crate) fn of(program: &Program, image: &Image, lanes: &Lanes) -> Self {
        let others: BTreeSet<u32> =
            parameters(program).chain(referred(program, image)).chain(results(program)).collect();
        let of = |is: fn(f64) -> bool| {
            let begins = move |register| is(number(program, register).unwrap_or_default());
            let variables = lanes.iter().filter(|(_, lane)| matches!(lane, Lane::Variable(_)));
            let own =
                variables.map(|(register, _)| register).filter(|register| !others.contains(&u32::from(*register)));
            own.filter(move |register| begins(*register)).collect()
        };
        let mut whole: BTreeSet<Register> = of(is_whole);
        while let Some(register) = refuted(program, |op| keeps_whole(&whole, op, lanes), &whole) {
            whole.remove(&register);
        }
        let mut truths: BTreeSet<Register> = of(is_truth);
        while let Some(register) = refuted(program, |op| keeps_truth(&truths, op, (program, image), lanes), &truths) {
            truths.remove(&register);
        }
        let bounds = |register| (register, bounds::everywhere(program, lanes, register));
        Self { whole: indexes(program, &whole).into_iter().map(bounds).collect(), truths }
    }

    /// What a register holds, if it is a variable.
    pub(crate) fn get(&self, register: Register) -> Sort {
        if self.whole.contains_key(&register) {
            Sort::Whole
        } else if self.truths.contains(&register) {
            Sort::Truth
        } else {
            Sort::Number
        }
    }

    /// The bounds of a whole number wherever the program is.
    pub(crate) fn bounds(&self, register: Register) -> Bounds {
        self.whole.get(&register).copied().unwrap_or(Bounds::EXACT)
    }

    /// Whether a frame with these numbers keeps to it, as far as the registers are `asked` for.
    pub(crate) fn suit(&self, numbers: &[f64], asked: impl Fn(&Register) -> bool) -> bool {
        let number = |register: &Register| numbers.get(usize::from(*register)).copied().unwrap_or_default();
        let suits = |register, bounds: &Bounds| Bounds::of(number(register)).is_some_and(|one| one.and(*bounds) == one);
        let mut whole = self.whole.iter().filter(|(register, _)| asked(register));
        let mut truths = self.truths.iter().filter(|register| asked(register));
        whole.all(|(register, bounds)| suits(register, bounds)) && truths.all(|register| is_truth(number(register)))
    }
}

/// Whether an operation writes a whole number, where these registers are some, or stops before it writes something else.
fn keeps_whole(registers: &BTreeSet<Register>, op: Op, lanes: &Lanes) -> bool {
    let has = |register| match lanes.get(register) {
        Lane::Constant(value) => is_whole(value),
        _ => registers.contains(&register),
    };
    match op {
        Op::Move { from: a, .. } => has(a),
        Op::Add { a, b, .. } | Op::Subtract { a, b, .. } | Op::Multiply { a, b, .. } => has(a) && has(b),
        Op::ForNext { counter, limit, .. } | Op::ForNextUp { counter, limit, .. } => has(counter) && has(limit + 1),
        _ => false,
    }
}

/// Whether an operation writes a truth value, where these registers are some.
fn keeps_truth(registers: &BTreeSet<Register>, op: Op, (program, image): (&Program, &Image), lanes: &Lanes) -> bool {
    match op {
        Op::Less { .. } | Op::LessEqual { .. } | Op::Equal { .. } | Op::NotEqual { .. } | Op::Not { .. } => true,
        Op::Move { from, .. } => match lanes.get(from) {
            Lane::Constant(value) => is_truth(value),
            _ => registers.contains(&from),
        },
        Op::LoadFirst { .. } | Op::LoadElement { .. } | Op::LoadElement2 { .. } => {
            container(op).is_some_and(|whole| Width::declared(whole.kind(), program, image) == Width::Byte)
        }
        _ => false,
    }
}

/// A register of these in which a step puts something that it does not keep to.
fn refuted(program: &Program, keeps: impl Fn(Op) -> bool, registers: &BTreeSet<Register>) -> Option<Register> {
    let mut writing = program.code.iter().filter_map(|step| Some((step.op, written(step.op)?)));
    writing.find(|(op, to)| registers.contains(to) && !keeps(*op)).map(|(_, to)| to)
}

/// Those of the registers that are indexes, and those from which they are made.
fn indexes(program: &Program, registers: &BTreeSet<Register>) -> BTreeSet<Register> {
    let ops = || program.code.iter().map(|step| step.op);
    let mut found: BTreeSet<Register> = ops().flat_map(index).filter(|index| registers.contains(index)).collect();
    loop {
        let makes = |op: Op| written(op).is_some_and(|to| found.contains(&to));
        let more: BTreeSet<Register> = ops().filter(|op| makes(*op)).flat_map(crate::operands::registers).collect();
        let before = found.len();
        found.extend(more.intersection(registers));
        if found.len() == before {
            return found;
        }
    }
}

/// Registers that operations may write for which there is no machine code.
fn results(program: &Program) -> impl Iterator<Item = u32> {
    let results = program.instructions.iter().filter_map(|site| site.result);
    let results = results.map(|(operand, base)| (operand, Kind::builtin(base, None).size.num));
    let copies = program.copies.iter().map(|site| (site.to, site.kind.size.num));
    results.chain(copies).flat_map(|(operand, count)| match operand {
        Operand::Frame(lanes) => lanes.num..lanes.num + count,
        Operand::Place(..) => 0..0,
    })
}

/// A whole number that machine code can keep as one.
pub(crate) fn is_whole(number: f64) -> bool {
    Bounds::of(number).is_some()
}

fn is_truth(number: f64) -> bool {
    [0.0_f64, 1.0].iter().any(|truth| truth.to_bits() == number.to_bits())
}
