//! What a program knows of containers: the fields of their descriptions, each in a variable.
//!
//! Only the interpreter gives a container another size or place, so machine code reads a description once, when the
//! program begins. What is then in a variable, the engine computes with outside of loops.

use val3_bytecode::{Op, Program};

use crate::containers::Shared;
use crate::lanes::Lanes;
use crate::layout::{ADDRESS, COLUMNS, COUNT, ROWS, SIZE, WIDTH};
use crate::local;
use crate::operands::container;

/// Fields at most: reading them takes time too, and there are only so many registers.
const MOST: usize = 48;

/// Fields of descriptions by their addresses, in the order of their variables.
#[derive(Debug, Default)]
pub(crate) struct Known {
    numbers: Vec<u32>,
    wholes: Vec<u32>,
    /// The variable of the first.
    first: u32,
}

impl Known {
    /// The fields that the operations of a program need; their variables are those behind its lanes.
    pub(crate) fn of(program: &Program, shared: &Shared, lanes: &Lanes) -> Self {
        let mut known = Self { first: local::LANES + lanes.variables(), ..Self::default() };
        for step in &program.code {
            let Some(at) = container(step.op).and_then(|whole| shared.description(whole)) else { continue };
            let (numbers, wholes): (&[u32], &[u32]) = match step.op {
                Op::LoadFirst { .. } | Op::StoreFirst { .. } => (&[], &[COUNT, ADDRESS]),
                Op::LoadElement2 { .. } | Op::StoreElement2 { .. } => (&[ROWS, COLUMNS], &[WIDTH, ADDRESS]),
                _ => (&[SIZE], &[ADDRESS]),
            };
            numbers.iter().for_each(|field| add(&mut known.numbers, at + field));
            wholes.iter().for_each(|field| add(&mut known.wholes, at + field));
        }
        known
    }

    /// How many variables are numbers, and how many are whole numbers.
    pub(crate) fn variables(&self) -> (u32, u32) {
        (count(&self.numbers), count(&self.wholes))
    }

    /// The numbers with their variables.
    pub(crate) fn numbers(&self) -> impl Iterator<Item = (u32, u32)> {
        variables(&self.numbers, self.first)
    }

    /// The whole numbers with their variables, which come behind those of the numbers.
    pub(crate) fn wholes(&self) -> impl Iterator<Item = (u32, u32)> {
        variables(&self.wholes, self.first + count(&self.numbers))
    }
}

fn add(fields: &mut Vec<u32>, at: u32) {
    if fields.len() < MOST && !fields.contains(&at) {
        fields.push(at);
    }
}

fn variables(fields: &[u32], first: u32) -> impl Iterator<Item = (u32, u32)> {
    fields.iter().zip(0..).map(move |(at, number)| (*at, first + number))
}

fn count(fields: &[u32]) -> u32 {
    u32::try_from(fields.len()).unwrap_or(u32::MAX)
}
