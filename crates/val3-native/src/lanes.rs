//! Where machine code has the numbers of a frame.

use val3_bytecode::{CallSite, Image, Operand, Pass, Passing, Program, ProgramRef, Register};

use crate::local;
use crate::operands::registers;

/// Where machine code has a number of a frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Lane {
    /// Nowhere: it is always this one.
    Constant(f64),
    /// In a variable of its own or a parameter, from the entry of the program to its exit.
    Variable(u32),
    /// In memory: a program that is called may change it by reference, or machine code has no use for it.
    Memory,
}

/// The numbers of the frame of one program.
pub(crate) struct Lanes(Vec<Lane>);

impl Lanes {
    /// Sorts the numbers of a frame.
    pub(crate) fn of(program: &Program, image: &Image) -> Self {
        let mut lanes = vec![Lane::Memory; program.frame.lanes.num as usize];
        let given: Vec<u32> = parameters(program).take(local::NUMBERS_GIVEN).collect();
        let mut variables = local::LANES..;
        for register in program.code.iter().flat_map(|step| registers(step.op)) {
            if let Some(lane @ Lane::Memory) = lanes.get_mut(usize::from(register)) {
                let parameter = (local::GIVEN..).zip(&given).find(|(_, given)| **given == u32::from(register));
                let variable = parameter.map(|(parameter, _)| parameter).or_else(|| variables.next());
                *lane = variable.map_or(Lane::Memory, Lane::Variable);
            }
        }
        for constant in &program.constants {
            if let Some((lane, value)) = lanes.get_mut(usize::from(*constant)).zip(number(program, *constant)) {
                *lane = Lane::Constant(value);
            }
        }
        for (start, count) in program.calls.iter().flat_map(|site| referred(site, image)) {
            let start = start as usize;
            lanes.iter_mut().skip(start).take(count as usize).for_each(|lane| *lane = Lane::Memory);
        }
        Self(lanes)
    }

    pub(crate) fn get(&self, register: Register) -> Lane {
        self.0.get(usize::from(register)).copied().unwrap_or(Lane::Memory)
    }

    /// How many variables there are besides the parameters; some of them may be in use for nothing.
    pub(crate) fn variables(&self) -> u32 {
        let ends = self.iter().map(|(_, lane)| if let Lane::Variable(at) = lane { at + 1 } else { 0 });
        ends.max().unwrap_or_default().saturating_sub(local::LANES)
    }

    /// Which of the numbers that are given as parameters a register has.
    pub(crate) fn parameter(&self, register: Register) -> Option<usize> {
        match self.get(register) {
            Lane::Variable(at) if at < local::LANES => Some((at - local::GIVEN) as usize),
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

/// The numbers of the caller that a program gets by reference: where they begin, and how many.
fn referred<'i>(site: &'i CallSite, image: &'i Image) -> impl Iterator<Item = (u32, u32)> + 'i {
    let callee = match site.program {
        ProgramRef::Own(number) => image.programs.get(usize::from(number)),
        ProgramRef::Import(_) => None,
    };
    let params = callee.map(|callee| callee.params.as_slice()).unwrap_or_default();
    params.iter().zip(site.passes.iter().flatten()).filter_map(|(param, pass)| match pass {
        Pass::Reference(Operand::Frame(lanes), _) => Some((lanes.num, param.kind.size.num)),
        _ => None,
    })
}
