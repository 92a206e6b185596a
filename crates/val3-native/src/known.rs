//! What a program knows of containers: the fields of their descriptions, each in a variable.
//!
//! Only the interpreter gives a container another size or place, so machine code reads a description once, when the
//! program begins. What is then in a variable, the engine computes with outside of loops.

use val3_bytecode::{Op, Program};

use crate::containers::Shared;
use crate::lanes::Lanes;
use crate::layout::{ADDRESS, COLUMNS, COUNT, ROWS, SIZE};
use crate::local;
use crate::operands::container;

/// Fields at most: reading them takes time too, and there are only so many registers.
const MOST: usize = 48;

/// Fields of descriptions by their addresses, in the order of their variables.
#[derive(Debug, Default)]
pub(crate) struct Known {
    fields: Vec<u32>,
    /// The variable of the first.
    first: u32,
}

impl Known {
    /// The fields that the operations of a program need; their variables are those behind its lanes.
    pub(crate) fn of(program: &Program, shared: &Shared, lanes: &Lanes) -> Self {
        let mut known = Self { first: local::LANES + lanes.variables(), ..Self::default() };
        for step in &program.code {
            let Some(at) = container(step.op).and_then(|whole| shared.description(whole)) else { continue };
            let fields: &[u32] = match step.op {
                Op::LoadFirst { .. } | Op::StoreFirst { .. } => &[COUNT, ADDRESS],
                Op::LoadElement2 { .. } | Op::StoreElement2 { .. } => &[ROWS, COLUMNS, ADDRESS],
                _ => &[SIZE, ADDRESS],
            };
            fields.iter().for_each(|field| known.add(at + field));
        }
        known
    }

    fn add(&mut self, at: u32) {
        if self.fields.len() < MOST && !self.fields.contains(&at) {
            self.fields.push(at);
        }
    }

    /// The fields with their variables.
    pub(crate) fn variables(&self) -> impl Iterator<Item = (u32, u32)> {
        self.fields.iter().copied().zip(self.first..)
    }
}
