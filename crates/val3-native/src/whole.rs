//! Registers that never hold a fraction: an index of those needs no rounding.

use std::collections::BTreeSet;

use val3_bytecode::{Image, Op, Program, Register};
use val3_lang::number_functions::NumberFunction;

use crate::lanes::{Lane, Lanes, number, parameters, referred};

/// The registers of one program in which machine code only puts whole numbers, or what is no number at all.
#[derive(Debug)]
pub(crate) struct WholeNumbers(Vec<Register>);

impl WholeNumbers {
    /// Supposes it of all variables, and takes out those in which a step may put something else, until none is left.
    /// Programs that are called may put anything in what they get by reference.
    pub(crate) fn of(program: &Program, image: &Image, lanes: &Lanes) -> Self {
        let given: Vec<u32> = parameters(program).chain(referred(program, image)).collect();
        let begins_whole = |register: Register| !number(program, register).is_some_and(has_fraction);
        let can_be = |(register, lane): &(Register, Lane)| match lane {
            Lane::Variable(_) => !given.contains(&u32::from(*register)) && begins_whole(*register),
            Lane::Constant(value) => !has_fraction(*value),
            Lane::Memory => false,
        };
        let mut whole = Self(lanes.iter().filter(can_be).map(|(register, _)| register).collect());
        loop {
            let refuted = whole.refuted(program);
            if refuted.is_empty() {
                return whole;
            }
            whole.0.retain(|register| !refuted.contains(register));
        }
    }

    pub(crate) fn has(&self, register: Register) -> bool {
        self.0.binary_search(&register).is_ok()
    }

    /// Whether a frame with these numbers keeps to it, as far as the registers are `asked` for.
    pub(crate) fn suit(&self, numbers: &[f64], asked: impl Fn(&Register) -> bool) -> bool {
        self.0
            .iter()
            .filter(|register| asked(register))
            .all(|register| !numbers.get(usize::from(*register)).copied().is_some_and(has_fraction))
    }

    /// Those of the registers in which a step may put a fraction.
    fn refuted(&self, program: &Program) -> BTreeSet<Register> {
        let fractions = program.code.iter().filter_map(|step| self.fraction(step.op));
        fractions.filter(|register| self.has(*register)).collect()
    }

    /// The register in which an operation may put a fraction.
    fn fraction(&self, op: Op) -> Option<Register> {
        let (to, is_whole) = match op {
            Op::Move { to, from: a } | Op::Negate { to, a } => (to, self.has(a)),
            Op::Add { to, a, b }
            | Op::Subtract { to, a, b }
            | Op::Multiply { to, a, b }
            | Op::Remainder { to, a, b } => (to, self.has(a) && self.has(b)),
            Op::ForNext { counter, limit, .. } | Op::ForNextUp { counter, limit, .. } => {
                (counter, self.has(counter) && self.has(limit + 1))
            }
            Op::Function { function, to, a, b, c } => (to, self.keeps_whole(function, [a, b, c])),
            Op::Divide { to, .. }
            | Op::Load { to, .. }
            | Op::LoadFirst { to, .. }
            | Op::LoadElement { to, .. }
            | Op::LoadElement2 { to, .. } => (to, false),
            // Truth values; and what machine code leaves to the interpreter.
            _ => return None,
        };
        (!is_whole).then_some(to)
    }

    fn keeps_whole(&self, function: NumberFunction, [a, b, c]: [Register; 3]) -> bool {
        match function {
            NumberFunction::Round
            | NumberFunction::RoundDown
            | NumberFunction::RoundUp
            | NumberFunction::And
            | NumberFunction::Or
            | NumberFunction::Xor => true,
            NumberFunction::Abs => self.has(a),
            NumberFunction::Min | NumberFunction::Max => self.has(a) && self.has(b),
            NumberFunction::Sel => self.has(b) && self.has(c),
            _ => false,
        }
    }
}

fn has_fraction(number: f64) -> bool {
    number.fract().abs() > 0.0
}
