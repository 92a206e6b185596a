//! How the steps of a program follow one another: blocks that are entered at their first step alone. They are left
//! behind their last, or on the way by jumps past a `return`.

use std::collections::{BTreeMap, BTreeSet};

use val3_bytecode::{Op, Program, Step};

use crate::rotation::{Rotated, jumps};

/// Lines behind which no block goes on beyond a jump: all of them have to be left in the turn when it begins.
const MOST_LINES: u32 = 16;

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
    /// `has_code` tells which operations machine code does; it stops before all others. `calls` tells behind which of
    /// them another function takes lines.
    pub(crate) fn of(program: &Program, has_code: impl Fn(Op) -> bool, calls: impl Fn(Op) -> bool) -> Self {
        let count = u32::try_from(program.code.len()).unwrap_or(u32::MAX);
        let mut flow = Self { blocks: BTreeMap::new() };
        for (first, lines) in blocks(&program.code, &has_code, calls) {
            flow.blocks.insert(first, Block { lines, line: None });
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
            let (mut line, mut goes_on) = (met, true);
            for (step, number) in steps(program, first, end).zip(first..) {
                if !has_code(step.op) {
                    goes_on = false;
                    break;
                }
                line = if step.line { LineBefore::Known(number) } else { line };
                if let Some(rotated) = Rotated::at(&program.code, number) {
                    let test = rotated.condition(&program.code).find(|(step, _)| step.line);
                    line = test.map_or(line, |(_, number)| LineBefore::Known(number));
                    open.push((rotated.end, line));
                    continue;
                }
                open.extend(target(step.op).map(|to| (to, line)));
                goes_on = !matches!(step.op, Op::Jump { .. } | Op::Return);
            }
            if goes_on {
                open.push((end, line));
            }
        }
    }
}

/// The first steps of all blocks, with the lines that begin in each.
fn blocks(code: &[Step], has_code: impl Fn(Op) -> bool, calls: impl Fn(Op) -> bool) -> Vec<(u32, u32)> {
    let targets: BTreeSet<u32> = jumps(code).map(|(_, to)| to).collect();
    let mut blocks: Vec<(u32, u32)> = Vec::new();
    let mut begins = true;
    for (step, number) in code.iter().zip(0..) {
        let line = u32::from(step.line && has_code(step.op));
        match blocks.last_mut() {
            Some((_, lines)) if !begins && !targets.contains(&number) => *lines += line,
            _ => blocks.push((number, line)),
        }
        let is_full = blocks.last().is_some_and(|(_, lines)| *lines >= MOST_LINES);
        let returns = |to| !is_full && returns_before(code, number, to);
        let leads_on = !matches!(step.op, Op::Jump { .. } | Op::Return) && target(step.op).is_none_or(returns);
        begins = !leads_on || !has_code(step.op) || calls(step.op);
    }
    blocks
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

/// Whether a jump skips what ends the program.
pub(crate) fn returns_before(code: &[Step], from: u32, to: u32) -> bool {
    let skipped = code.get(from as usize..to as usize).unwrap_or_default();
    skipped.last().is_some_and(|step| step.op == Op::Return)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn blocks_of(ops: &[Op]) -> Vec<(u32, u32)> {
        let code: Vec<Step> = ops.iter().map(|op| Step { op: *op, line: true }).collect();
        blocks(&code, |op| op != Op::Line, |op| matches!(op, Op::Call { .. }))
    }

    #[test]
    fn a_block_goes_on_behind_a_jump_past_a_return() {
        let negate = Op::Negate { to: 0, a: 1 };
        let leaving = [Op::UnlessLess { a: 0, b: 1, to: 3 }, negate, Op::Return, negate, Op::Return];
        assert_eq!(blocks_of(&leaving), [(0, 3), (3, 2)]);
        let round = [negate, Op::UnlessLess { a: 0, b: 1, to: 4 }, negate, Op::Jump { to: 1 }, Op::Return];
        assert_eq!(blocks_of(&round), [(0, 1), (1, 1), (2, 2), (4, 1)]);
        let again = [negate, Op::IfLess { a: 0, b: 1, to: 0 }, Op::Return];
        assert_eq!(blocks_of(&again), [(0, 2), (2, 1)], "what follows a loop is not part of it");
    }

    #[test]
    fn a_block_ends_before_it_is_long_and_at_what_has_no_code() {
        let mut ops = vec![Op::UnlessLess { a: 0, b: 1, to: 21 }; 20];
        ops.extend([Op::Return; 2]);
        assert_eq!(blocks_of(&ops), [(0, 16), (16, 5), (21, 1)]);
        assert_eq!(blocks_of(&[Op::Negate { to: 0, a: 1 }, Op::Line, Op::Return]), [(0, 1), (2, 1)]);
    }
}
