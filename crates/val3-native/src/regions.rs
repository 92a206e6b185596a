//! Loops, and what goes on where: the structure that WebAssembly asks for.
//!
//! A region is a loop, or the program as a whole. A jump forward leaves blocks that end where it goes to; all of those
//! that end directly in a region begin where the region does. A jump backward goes to the head of a loop. A jump into
//! a loop, and the entry of the program at the head of one, go to the heads of the loops around, each of which leads
//! on to the next.

use std::collections::BTreeSet;

use val3_bytecode::Program;

use crate::rotation::jumps;

/// A loop, or the program.
#[derive(Debug)]
pub(crate) struct Region {
    /// Its first step.
    pub(crate) head: u32,
    /// The step behind its last.
    pub(crate) end: u32,
    /// Where blocks end that are left by jumps, directly in this region.
    pub(crate) labels: BTreeSet<u32>,
    /// The steps at which it is entered: its head, and those to which that leads on.
    pub(crate) entries: BTreeSet<u32>,
}

/// The program and its loops.
pub(crate) struct Regions {
    program: Region,
    /// Those that begin first come first, so the outer before the inner.
    loops: Vec<Region>,
}

impl Regions {
    pub(crate) fn of(program: &Program) -> Self {
        let count = u32::try_from(program.code.len()).unwrap_or(u32::MAX);
        let jumps: Vec<(u32, u32)> = jumps(&program.code).collect();
        let spans = loops(&jumps);
        let region =
            |(head, end): (u32, u32)| Region { head, end, entries: BTreeSet::from([head]), labels: BTreeSet::new() };
        let mut regions = Self { program: region((0, count)), loops: spans.iter().copied().map(region).collect() };
        for (from, to) in jumps.iter().filter(|(from, to)| from < to) {
            let around = regions.innermost(*from, *to);
            regions.lead(around, *to);
        }
        for (head, _) in spans {
            regions.program.entries.insert(head);
            regions.lead(None, head);
        }
        regions
    }

    pub(crate) fn program(&self) -> &Region {
        &self.program
    }

    /// The loop with this head.
    pub(crate) fn at(&self, head: u32) -> Option<&Region> {
        self.loops.iter().find(|region| region.head == head)
    }

    /// The steps at which the program can be entered.
    pub(crate) fn entries(&self) -> &BTreeSet<u32> {
        &self.program.entries
    }

    /// The label by which a step is reached from a region around it.
    pub(crate) fn label(&self, region: &Region, step: u32) -> u32 {
        let around = self.loops.iter().position(|known| std::ptr::eq(known, region));
        self.within(around, step).map_or(step, |(_, inner)| inner.head)
    }

    /// The label by which a step that is not in the regions of another is reached from there.
    pub(crate) fn way(&self, from: u32, to: u32) -> u32 {
        self.within(self.innermost(from, to), to).map_or(to, |(_, inner)| inner.head)
    }

    /// The innermost loop that has both steps.
    fn innermost(&self, one: u32, other: u32) -> Option<usize> {
        self.loops.iter().rposition(|region| region.has(one) && region.has(other))
    }

    /// The outermost loop within another, or within the program, that has the step.
    fn within(&self, around: Option<usize>, step: u32) -> Option<(usize, &Region)> {
        let inner = self.loops.iter().enumerate().skip(around.map_or(0, |around| around + 1));
        inner.filter(|(_, inner)| inner.has(step)).min_by_key(|(number, _)| *number)
    }

    /// Makes the way from a loop, or from the program, to a step in it.
    fn lead(&mut self, mut region: Option<usize>, step: u32) {
        loop {
            let inner = self.within(region, step).map(|(number, inner)| (number, inner.head));
            let label = inner.map_or(step, |(_, head)| head);
            let around = match region {
                Some(number) => self.loops.get_mut(number),
                None => Some(&mut self.program),
            };
            if let Some(around) = around {
                around.labels.insert(label);
            }
            region = inner.filter(|_| label != step).map(|(inner, _)| inner);
            let Some(inner) = region.and_then(|inner| self.loops.get_mut(inner)) else { return };
            inner.entries.insert(step);
        }
    }
}

impl Region {
    /// It is entered at its head alone, so that nothing has to lead on from there.
    pub(crate) fn begins_at_head(&self) -> bool {
        self.entries.len() == 1
    }

    fn has(&self, step: u32) -> bool {
        (self.head..self.end).contains(&step)
    }
}

/// First steps of loops with the steps behind their last, in order; none overlaps another without being in it.
fn loops(jumps: &[(u32, u32)]) -> Vec<(u32, u32)> {
    let heads: BTreeSet<u32> = jumps.iter().filter(|(from, to)| to <= from).map(|(_, to)| *to).collect();
    let end = |head: u32| jumps.iter().filter(|(_, to)| *to == head).map(|(from, _)| from + 1).max().unwrap_or(head);
    let mut spans: Vec<(u32, u32)> = heads.into_iter().map(|head| (head, end(head))).collect();
    loop {
        let crossing = |(head, end): (u32, u32)| {
            let crossed = spans.iter().filter(|(other, far)| head < *other && *other < end && end < *far);
            crossed.map(|(_, far)| *far).max()
        };
        let Some((at, far)) = spans.iter().enumerate().find_map(|(at, span)| Some((at, crossing(*span)?))) else {
            return spans;
        };
        if let Some(span) = spans.get_mut(at) {
            span.1 = far;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::loops;

    #[test]
    fn loops_stand_within_one_another() {
        assert_eq!(loops(&[(0, 5), (9, 3), (7, 4), (7, 3)]), [(3, 10), (4, 8)]);
        let crossing = [(5, 1), (8, 3), (12, 7)];
        assert_eq!(loops(&crossing), [(1, 13), (3, 13), (7, 13)], "each reaches as far as the one it crosses");
        assert!(loops(&[(1, 2)]).is_empty());
    }
}
