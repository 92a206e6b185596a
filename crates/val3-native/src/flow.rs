//! How the steps of a program follow one another: blocks that are done from their first step to their last.

use std::collections::{BTreeMap, BTreeSet};

use val3_bytecode::{Op, Program, Step};

/// The line that a task is in before a step.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum LineBefore {
    /// The one that begins with this step, whichever way was taken.
    Known(u32),
    /// It depends on the way: the code keeps it in a variable.
    Kept,
}

/// A block.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Block {
    /// The lines that begin in it.
    pub(crate) lines: u32,
    /// The line before; `None` where no way leads to.
    pub(crate) line: Option<LineBefore>,
}

/// The blocks of a program, by their first steps.
pub(crate) struct Flow {
    blocks: BTreeMap<u32, Block>,
}

impl Flow {
    /// `has_code` tells which operations machine code does; it stops before all others.
    pub(crate) fn of(program: &Program, has_code: impl Fn(Op) -> bool) -> Self {
        let mut firsts = BTreeSet::from([0]);
        for (step, number) in program.code.iter().zip(0..) {
            firsts.extend(target(step.op));
            if ends_block(step.op) || !has_code(step.op) {
                firsts.insert(number + 1);
            }
        }
        let count = u32::try_from(program.code.len()).unwrap_or(u32::MAX);
        let mut flow = Self { blocks: BTreeMap::new() };
        for first in firsts.iter().copied().filter(|first| *first < count) {
            let end = firsts.range(first + 1..).next().copied().unwrap_or(count).min(count);
            let begins = |step: &&Step| step.line && has_code(step.op);
            let lines = steps(program, first, end).filter(begins).count();
            flow.blocks.insert(first, Block { lines: u32::try_from(lines).unwrap_or(u32::MAX), line: None });
        }
        flow.follow_lines(program, count, has_code);
        flow
    }

    pub(crate) fn block(&self, first: u32) -> Option<Block> {
        self.blocks.get(&first).copied()
    }

    /// The line before each block, from the beginning of the program on.
    fn follow_lines(&mut self, program: &Program, count: u32, has_code: impl Fn(Op) -> bool) {
        let mut open = vec![(0, LineBefore::Known(0))];
        while let Some((first, line)) = open.pop() {
            let end = self.blocks.range(first + 1..).next().map_or(count, |(next, _)| *next);
            let Some(block) = self.blocks.get_mut(&first) else { continue };
            let met = match block.line {
                None => line,
                Some(known) if known == line => continue,
                Some(_) => LineBefore::Kept,
            };
            if block.line == Some(met) {
                continue;
            }
            block.line = Some(met);
            let last_line = (first..end).zip(steps(program, first, end)).filter(|(_, step)| step.line).last();
            let after = last_line.map_or(met, |(number, _)| LineBefore::Known(number));
            let Some(last) = steps(program, first, end).last().filter(|last| has_code(last.op)) else { continue };
            open.extend(target(last.op).map(|to| (to, after)));
            if !matches!(last.op, Op::Jump { .. } | Op::Return) {
                open.push((end, after));
            }
        }
    }
}

fn steps(program: &Program, first: u32, end: u32) -> impl Iterator<Item = &Step> {
    program.code.iter().take(end as usize).skip(first as usize)
}

/// Where an operation may go on instead of at the next one.
pub(crate) fn target(mut op: Op) -> Option<u32> {
    match op {
        Op::WaitUntil { .. } | Op::Watch { .. } => None,
        _ => op.target_mut().copied(),
    }
}

/// Other steps than the next one may follow, or other programs take lines.
fn ends_block(op: Op) -> bool {
    target(op).is_some() || matches!(op, Op::Return | Op::Call { .. })
}
