//! Where machine code has the numbers of a frame.

use val3_bytecode::{CallSite, Image, Operand, Pass, Passing, Program, ProgramRef, Register};

use crate::local::NUMBERS_GIVEN;
use crate::operands::registers;

/// Where machine code has a number of a frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Lane {
    /// Nowhere: it is always this one.
    Constant(f64),
    /// In a variable of its own, from the entry of the program to its exit: the one with this number among those of
    /// the program. The first [`NUMBERS_GIVEN`] are parameters.
    Variable(u32),
    /// In memory: machine code has no use for it.
    Memory,
}

/// The numbers of the frame of one program.
pub(crate) struct Lanes(Vec<Lane>);

impl Lanes {
    /// Sorts the numbers of a frame.
    pub(crate) fn of(program: &Program, image: &Image) -> Self {
        let mut lanes = vec![Lane::Memory; program.frame.lanes.num as usize];
        let mut variables = NUMBERS_GIVEN..;
        let used = program.code.iter().flat_map(|step| registers(step.op)).map(u32::from);
        for register in used.chain(referred(program, image)) {
            if let Some(lane @ Lane::Memory) = lanes.get_mut(register as usize) {
                let mut parameters = (0..NUMBERS_GIVEN).zip(parameters(program));
                let parameter = parameters.find(|(_, given)| *given == register);
                let variable = parameter.map(|(parameter, _)| parameter).or_else(|| variables.next());
                *lane = variable.map_or(Lane::Memory, Lane::Variable);
            }
        }
        for constant in &program.constants {
            if let Some((lane, value)) = lanes.get_mut(usize::from(*constant)).zip(number(program, *constant)) {
                *lane = Lane::Constant(value);
            }
        }
        Self(lanes)
    }

    pub(crate) fn get(&self, register: Register) -> Lane {
        self.0.get(usize::from(register)).copied().unwrap_or(Lane::Memory)
    }

    /// How many variables there are, with [`NUMBERS_GIVEN`] parameters; some of them may be in use for nothing.
    pub(crate) fn variables(&self) -> u32 {
        let ends = self.iter().map(|(_, lane)| if let Lane::Variable(at) = lane { at + 1 } else { 0 });
        ends.max().unwrap_or_default().max(NUMBERS_GIVEN)
    }

    /// Which of the numbers that are given as parameters a register has.
    pub(crate) fn parameter(&self, register: Register) -> Option<u32> {
        match self.get(register) {
            Lane::Variable(at) if at < NUMBERS_GIVEN => Some(at),
            _ => None,
        }
    }

    pub(crate) fn iter(&self) -> impl Iterator<Item = (Register, Lane)> + '_ {
        (0..).zip(self.0.iter().copied())
    }
}

/// The number that a register of a new frame holds.
pub(crate) fn number(program: &Program, register: Register) -> Option<f64> {
    program.nums.get(usize::from(register)).copied()
}

/// The registers that the parameters by value of a program have.
pub(crate) fn parameters(program: &Program) -> impl Iterator<Item = u32> + '_ {
    program.params.iter().filter_map(|param| match param.passing {
        Passing::Value(_, lanes) => Some(lanes.num),
        _ => None,
    })
}

/// The numbers of its frame that a program passes by reference.
pub(crate) fn referred<'p>(program: &'p Program, image: &'p Image) -> impl Iterator<Item = u32> + 'p {
    program.calls.iter().flat_map(|site| referred_by(site, image))
}

fn referred_by<'i>(site: &'i CallSite, image: &'i Image) -> impl Iterator<Item = u32> + 'i {
    let callee = match site.program {
        ProgramRef::Own(number) => image.programs.get(usize::from(number)),
        ProgramRef::Import(_) => None,
    };
    let params = callee.map(|callee| callee.params.as_slice()).unwrap_or_default();
    let numbers = params.iter().zip(site.passes.iter().flatten()).filter_map(|(param, pass)| match pass {
        Pass::Reference(Operand::Frame(lanes), _) => Some(lanes.num..lanes.num + param.kind.size.num),
        _ => None,
    });
    numbers.flatten()
}
