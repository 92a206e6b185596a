//! The steps at which machine code can be entered: a block of code begins with each.

use val3_bytecode::{Op, Program};

/// The first steps of the blocks of a program, in order; the first is 0.
pub(crate) struct Blocks(Vec<u32>);

impl Blocks {
    /// A block begins with each line, behind each call, and where something goes on or waits.
    pub(crate) fn of(program: &Program) -> Self {
        let mut firsts = vec![0];
        for (step, number) in program.code.iter().zip(0..) {
            if step.line {
                firsts.push(number);
            }
            if matches!(step.op, Op::Call { .. }) {
                firsts.push(number + 1);
            }
            let mut op = step.op;
            firsts.extend(op.target_mut().copied());
        }
        firsts.retain(|first| (*first as usize) < program.code.len());
        firsts.sort_unstable();
        firsts.dedup();
        Self(firsts)
    }

    pub(crate) fn len(&self) -> u32 {
        u32::try_from(self.0.len()).unwrap_or(u32::MAX)
    }

    /// The block that begins with a step.
    pub(crate) fn at(&self, step: u32) -> Option<u32> {
        self.0.binary_search(&step).ok().and_then(|at| u32::try_from(at).ok())
    }
}
