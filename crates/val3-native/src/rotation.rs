//! Loops whose condition stands behind their block, as that of a `while` does: they begin with a jump to it.
//!
//! Machine code has the condition once more in place of that jump. So the loop is entered at its head alone, and its
//! condition belongs to the block of steps before it.

use val3_bytecode::{Op, Step};

use crate::body::{Body, Label};
use crate::flow::target;

/// Steps of a condition that is there twice.
const SHORT: usize = 8;

/// A loop that begins with its condition.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Rotated {
    /// The first step of its block.
    pub(crate) head: u32,
    /// The first step of its condition.
    pub(crate) test: u32,
    /// The step behind its condition.
    pub(crate) end: u32,
}

impl Rotated {
    /// The loop that begins with a step: with a jump to a condition that leads to the step behind the jump or out.
    pub(crate) fn at(code: &[Step], number: u32) -> Option<Self> {
        let Op::Jump { to: test } = code.get(number as usize)?.op else { return None };
        let head = number + 1;
        let end = (0..).zip(code).filter(|(_, step)| target(step.op) == Some(head)).map(|(from, _)| from + 1).max()?;
        let condition = code.get(test as usize..end as usize).filter(|steps| head < test && steps.len() <= SHORT)?;
        let leads_on = |step: &Step| target(step.op).is_none_or(|to| to == head || to == end);
        condition.iter().all(leads_on).then_some(Self { head, test, end })
    }

    /// The steps of its condition with their numbers.
    pub(crate) fn condition(self, code: &[Step]) -> impl Iterator<Item = (Step, u32)> {
        code.iter().copied().zip(0..).skip(self.test as usize).take((self.end - self.test) as usize)
    }
}

/// From where to where machine code jumps. The first jump of a rotated loop leads past it.
pub(crate) fn jumps(code: &[Step]) -> impl Iterator<Item = (u32, u32)> {
    code.iter().zip(0..).filter_map(|(step, from)| {
        let to = target(step.op)?;
        Some((from, Rotated::at(code, from).map_or(to, |rotated| rotated.end)))
    })
}

impl Body<'_> {
    /// The condition of a loop before the first round.
    pub(crate) fn rotate(&mut self, rotated: Rotated) {
        let condition: Vec<_> = rotated.condition(&self.program.code).collect();
        let lines = condition.iter().filter(|(step, _)| step.line).count();
        self.open_block(Label::Loop(rotated.head));
        self.take_lines(rotated.test, u32::try_from(lines).unwrap_or(u32::MAX));
        let ends = condition.into_iter().any(|step| {
            self.step = step;
            self.operation()
        });
        if !ends {
            self.jump(rotated.end);
        }
        self.close();
        self.ahead = 0;
    }
}
