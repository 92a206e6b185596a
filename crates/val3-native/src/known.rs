//! What a program knows of containers: the fields of their descriptions, each in a variable.
//!
//! Only the interpreter gives a container another size or place, so machine code reads a description once, when the
//! program begins. What is then in a variable, the engine computes with outside of loops.

use val3_bytecode::{Op, Program};
use wasm_encoder::ValType;

use crate::containers::Shared;
use crate::draft::Draft;
use crate::layout::{ADDRESS, COLUMNS, COUNT, ROWS, SIZE};
use crate::operands::container;

/// Fields at most: reading them takes time too, and there are only so many registers.
const MOST: usize = 48;

/// Fields of descriptions by their addresses, with their variables.
#[derive(Debug, Default)]
pub(crate) struct Known(Vec<(u32, u32)>);

impl Known {
    /// The fields that the operations of the programs of a function need.
    pub(crate) fn of(programs: &[&Program], shared: &Shared, draft: &mut Draft) -> Self {
        let mut known = Self::default();
        for step in programs.iter().flat_map(|program| &program.code) {
            let Some(at) = container(step.op).and_then(|whole| shared.description(whole)) else { continue };
            let fields: &[u32] = match step.op {
                Op::LoadFirst { .. } | Op::StoreFirst { .. } | Op::LocateFirst { .. } => &[COUNT, ADDRESS],
                Op::LoadElement2 { .. } | Op::StoreElement2 { .. } | Op::Locate2 { .. } => &[ROWS, COLUMNS, ADDRESS],
                _ => &[SIZE, ADDRESS],
            };
            fields.iter().for_each(|field| known.add(at + field, draft));
        }
        known
    }

    fn add(&mut self, at: u32, draft: &mut Draft) {
        if self.0.len() < MOST && self.variables().all(|(known, _)| known != at) {
            self.0.push((at, draft.variable(ValType::I32)));
        }
    }

    /// The fields with their variables.
    pub(crate) fn variables(&self) -> impl Iterator<Item = (u32, u32)> {
        self.0.iter().copied()
    }
}
