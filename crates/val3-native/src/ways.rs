//! The ways through a program: blocks, loops, jumps, and the exits to the interpreter.

use wasm_encoder::BlockType;

use crate::body::{Body, Label};
use crate::flow::{LineBefore, returns_before};
use crate::local;
use crate::regions::Region;

impl Body<'_> {
    /// All steps, or those before the one behind which a label is that a jump to it leaves.
    pub(crate) fn steps(&mut self, end: Option<u32>) {
        let around = self.labels.len();
        self.open_block(Label::Stop);
        self.open_region(self.study.regions.program());
        let mut is_dead = false;
        for (step, number) in self.program.code.iter().zip(0..end.unwrap_or(u32::MAX)) {
            is_dead = !self.arrive(number, is_dead);
            if !is_dead {
                self.step = (*step, number);
                is_dead = self.operation();
            }
        }
        self.code().unreachable();
        while self.labels.len() > around {
            self.close();
        }
    }

    pub(crate) fn open_block(&mut self, label: Label) {
        self.code().block(BlockType::Empty);
        self.labels.push(label);
    }

    pub(crate) fn close(&mut self) {
        self.code().end();
        self.labels.pop();
    }

    /// Opens the blocks that end in a region, and leads on to where it is entered.
    fn open_region(&mut self, region: &Region) {
        for label in region.labels.iter().rev() {
            // The end of an opening is a label already.
            if !self.labels.contains(&Label::Step(*label)) {
                self.open_block(Label::Step(*label));
            }
        }
        if region.begins_at_head() {
            return;
        }
        self.code().local_get(local::NEXT);
        self.when(|body| {
            for entry in &region.entries {
                body.code().local_get(local::NEXT).i32_const(name(*entry).cast_signed()).i32_eq();
                body.when(|body| body.enter(region, *entry));
            }
            // All ways of a loop lead on from here: what never falls through is out of the way of the rounds.
            if body.depth(Label::Loop(region.head)).is_some() {
                body.code().unreachable();
            }
        });
    }

    /// Goes to a step by which a region is entered. Where that is the head of another, it leads on.
    fn enter(&mut self, region: &Region, entry: u32) {
        let label = self.study.regions.label(region, entry);
        let leads_on = self.study.regions.at(entry).is_some_and(|inner| !inner.begins_at_head());
        let is_here = label == entry && (region.head == entry || !leads_on);
        if is_here {
            self.code().i32_const(0).local_set(local::NEXT);
        }
        if let Some(out) = self.depth(Label::Step(label)).or_else(|| self.depth(Label::Loop(region.head))) {
            self.code().br(out);
        }
    }

    /// Comes to a step, on the way from the one before unless that `is_dead`. Whether any way leads there.
    fn arrive(&mut self, step: u32, is_dead: bool) -> bool {
        while let Some(Label::Loop(head)) = self.labels.last()
            && self.study.regions.at(*head).is_none_or(|region| region.end <= step)
        {
            self.close();
        }
        if !is_dead {
            self.keep_line(step);
        }
        let mut is_reached = !is_dead;
        while self.labels.last() == Some(&Label::Step(step)) {
            self.close();
            is_reached = true;
        }
        if let Some(region) = self.study.regions.at(step) {
            self.code().loop_(BlockType::Empty);
            self.labels.push(Label::Loop(step));
            self.open_region(region);
        }
        if is_reached {
            self.begin_block(step);
        }
        is_reached
    }

    /// Takes the lines of a block from the budget, if one begins here.
    fn begin_block(&mut self, step: u32) {
        let Some(block) = self.study.flow.block(step) else { return };
        self.facts.clear();
        self.line = block.line.unwrap_or(LineBefore::Kept);
        self.stop_at_fill(step);
        self.take_lines(step, block.lines);
    }

    /// Takes the lines that begin from a step on from the budget.
    pub(crate) fn take_lines(&mut self, step: u32, count: u32) {
        self.ahead = count;
        if count > 0 {
            self.code().local_get(local::BUDGET);
            self.lines(count);
            self.code().i32_sub().local_tee(local::BUDGET).i32_const(0).i32_lt_s();
            self.when(|body| {
                body.give_back(count);
                body.stop_at(step);
            });
        }
    }

    /// The line of the step at hand begins, if one does.
    pub(crate) fn begin_line(&mut self) {
        let (step, number) = self.step;
        if step.line {
            self.ahead = self.ahead.saturating_sub(1);
            self.line = LineBefore::Known(number);
        }
    }

    /// How many labels are within this one.
    pub(crate) fn depth(&self, label: Label) -> Option<u32> {
        let within = self.labels.iter().rev().position(|known| *known == label)?;
        u32::try_from(within).ok()
    }

    /// What is done if the condition on the stack holds, which is the rare case: the engine puts it out of the way.
    pub(crate) fn when(&mut self, act: impl FnOnce(&mut Self)) {
        self.code().if_(BlockType::Empty);
        self.labels.push(Label::Condition);
        act(self);
        self.close();
    }

    /// What is done if the condition on the stack does not hold, which is the rare case.
    pub(crate) fn unless(&mut self, act: impl FnOnce(&mut Self)) {
        self.code().i32_eqz();
        self.when(act);
    }

    /// What is done if the condition on the stack holds, and what if not.
    pub(crate) fn when_else(&mut self, act: impl FnOnce(&mut Self), other: impl FnOnce(&mut Self)) {
        self.code().if_(BlockType::Empty);
        self.labels.push(Label::Condition);
        act(self);
        self.code().else_();
        other(self);
        self.close();
    }

    /// Goes on at another step, and gives back the lines of the block that have not begun.
    pub(crate) fn jump(&mut self, to: u32) {
        self.give_back(self.ahead);
        self.keep_line(to);
        let (_, from) = self.step;
        if let Some(out) = self.label(to) {
            self.code().br(out);
        } else if let Some(out) = self.depth(Label::Step(self.study.regions.way(from, to))) {
            self.code().i32_const(name(to).cast_signed()).local_set(local::NEXT).br(out);
        } else {
            self.stop_at(to);
        }
    }

    /// Goes on at another step if the condition on the stack holds.
    pub(crate) fn jump_if(&mut self, to: u32) {
        if let Some(out) = self.direct(to) {
            self.keep_line(to);
            self.code().br_if(out);
        } else {
            self.code().i32_eqz();
            self.jump_unless(to);
        }
    }

    /// Goes on at another step if the condition on the stack does not hold. That a loop is repeated is not rare, nor that
    /// a program does not return on the way.
    pub(crate) fn jump_unless(&mut self, to: u32) {
        let (_, from) = self.step;
        if self.direct(to).is_some() {
            self.code().i32_eqz();
            self.jump_if(to);
        } else if to <= from || returns_before(&self.program.code, from, to) {
            self.when_else(|_| {}, |body| body.jump(to));
        } else {
            self.unless(|body| body.jump(to));
        }
    }

    /// The label of a step, if a jump to it is all there is to do.
    fn direct(&self, to: u32) -> Option<u32> {
        self.label(to).filter(|_| self.ahead == 0)
    }

    /// The label of a step: a jump backward leads to the head of a loop.
    fn label(&self, to: u32) -> Option<u32> {
        let (_, from) = self.step;
        self.depth(if to <= from { Label::Loop(to) } else { Label::Step(to) })
    }

    /// The line at hand goes to its variable where the block that follows looks for it there.
    fn keep_line(&mut self, next: u32) {
        if self.study.flow.block(next).is_some_and(|block| block.line == Some(LineBefore::Kept)) {
            self.write_line();
        }
    }

    fn write_line(&mut self) {
        if let LineBefore::Known(line) = self.line {
            let kept = self.frame.line;
            self.code().i32_const(line.cast_signed()).local_set(kept);
        }
    }

    /// The interpreter goes on at a step.
    pub(crate) fn stop_at(&mut self, step: u32) {
        self.write_line();
        for register in self.study.temporaries.at(step, self.program) {
            self.save(register);
        }
        let out = self.depth(Label::Stop).unwrap_or_default();
        self.code().i32_const(step.cast_signed()).local_set(local::STEP).br(out);
    }

    /// The interpreter does the operation at hand, and begins its line and those behind it in the block.
    pub(crate) fn leave_it(&mut self) {
        let (step, number) = self.step;
        self.give_back(self.ahead + u32::from(step.line));
        self.stop_at(number);
    }

    pub(crate) fn give_back(&mut self, lines: u32) {
        if lines > 0 {
            self.code().local_get(local::BUDGET).i32_const(lines.cast_signed()).i32_add().local_set(local::BUDGET);
        }
    }
}

/// What a step is called where the code is told to begin with it; 0 stands for none.
pub(crate) fn name(step: u32) -> u32 {
    step.wrapping_add(1)
}
