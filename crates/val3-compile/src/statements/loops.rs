//! Loops (2.2.5).

use val3_analysis::body::{ExprId, Stmt};
use val3_bytecode::{Op, Register, Subscript};

use crate::code::Label;
use crate::counting::{BranchId, END, FALSE, ROUND, TRUE};
use crate::emitter::text_register;
use crate::error::{CompileLimit, Result};
use crate::location::num_register;
use crate::location::{CompiledValue, ValueLocator};
use crate::statements::Statements;
use crate::statements::head;

/// Counter of a `for`, with its registers.
struct Counter {
    variable: CompiledValue,
    /// Register that counts.
    register: Register,
    /// Register with the limit. The next register contains the step.
    limit: Register,
    /// Whether the step is known to be positive.
    is_up: bool,
}

impl Statements<'_, '_> {
    /// Compiles a `while`. The condition follows the block, so that an iteration needs one jump.
    pub(crate) fn while_stmt(&mut self, stmt: &Stmt, condition: Option<ExprId>, block: &[Stmt]) -> Result<()> {
        let condition = condition.ok_or(CompileLimit::Unclear)?;
        let range = head(stmt, self.values.body().range(condition));
        let line = self.out().code().later_line(range);
        let test = self.out().code().label();
        self.out().emit(Op::Jump { to: test.0 });
        let again = self.out().code().here();
        let branch = self.branch_at(condition);
        self.out().code().side(branch, TRUE, block);
        self.block(block)?;
        self.loop_end(stmt);
        self.out().code().place(test);
        self.range = range;
        self.out().code().begin_line(line);
        self.condition(condition, true, again)?;
        self.out().code().side(branch, FALSE, &[]);
        Ok(())
    }

    pub(crate) fn do_stmt(&mut self, condition: Option<ExprId>, block: &[Stmt]) -> Result<()> {
        let condition = condition.ok_or(CompileLimit::Unclear)?;
        let again = self.out().code().here();
        self.block(block)?;
        let range = self.values.body().range(condition);
        self.range = range;
        self.out().code().line(range);
        match self.branch_at(condition) {
            None => self.condition(condition, false, again),
            branch => self.counted_end(condition, again, branch),
        }
    }

    /// Compiles the condition of a counted `until`. The side `false` has a separate operation, which the entry into the
    /// loop does not execute.
    fn counted_end(&mut self, condition: ExprId, again: Label, branch: Option<BranchId>) -> Result<()> {
        let end = self.out().code().label();
        self.condition(condition, true, end)?;
        self.out().code().side(branch, FALSE, &[]);
        self.out().emit(Op::Jump { to: again.0 });
        self.out().code().place(end);
        self.out().code().side(branch, TRUE, &[]);
        Ok(())
    }

    /// Compiles a `for`. Start, limit and step are computed once, in this order, before the first assignment to the
    /// counter.
    pub(crate) fn for_stmt(&mut self, stmt: &Stmt, parts: [Option<ExprId>; 4], block: &[Stmt]) -> Result<()> {
        let [Some(counter), Some(start), Some(stop), step] = parts else { return Err(CompileLimit::Unclear) };
        let range = head(stmt, self.values.body().range(step.unwrap_or(stop)));
        self.out().code().line(range);
        let ids: Vec<ExprId> = [counter, start, stop].into_iter().chain(step).collect();
        match self.or_stop(&ids, |statements| statements.counter(counter, start, stop, step))? {
            Some(counter) => {
                let branch = self.out().code().branch(range);
                self.rounds(&counter, stmt, block, branch)
            }
            None => Ok(()),
        }
    }

    /// Computes the counter, the limit and the step of a `for`.
    fn counter(&mut self, counter: ExprId, start: ExprId, stop: ExprId, step: Option<ExprId>) -> Result<Counter> {
        let variable = self.values.variable(counter)?.ok_or(CompileLimit::Unclear)?;
        let variable = CompiledValue { location: self.pinned(variable.location)?, ..variable };
        let fixed = self.fixed_end(stop, step)?;
        let limit = fixed.map_or_else(|| self.out().frame_mut().nums(2), Ok)?;
        let register = match variable.location {
            ValueLocator::Frame(lanes) => num_register(lanes),
            _ => self.out().frame_mut().num()?,
        };
        let start = self.values.num(start)?;
        if fixed.is_none() {
            self.values.num_to(stop, limit)?;
            self.step(step, limit + 1)?;
        }
        self.out().move_num(register, start);
        let is_up = step.is_none_or(|step| self.values.constant(step).is_some_and(|(_, step)| step > 0.0));
        Ok(Counter { variable, register, limit, is_up })
    }

    /// Returns the registers with limit and step if both are constants. They are valid even if `taskResume` has jumped
    /// past the head of the loop.
    fn fixed_end(&mut self, stop: ExprId, step: Option<ExprId>) -> Result<Option<Register>> {
        let Some((_, limit)) = self.values.constant(stop) else { return Ok(None) };
        let step = step.map_or(Some(1.0), |step| self.values.constant(step).map(|(_, step)| step));
        step.map(|step| self.out().frame_mut().constant_pair([limit, step])).transpose()
    }

    fn rounds(&mut self, counts: &Counter, stmt: &Stmt, block: &[Stmt], branch: Option<BranchId>) -> Result<()> {
        let Counter { variable, register: counter, limit, is_up } = *counts;
        let (exit, body) = (self.out().code().label(), self.out().code().label());
        self.out().emit(Op::ForTest { counter, limit, exit: exit.0 });
        self.out().code().place(body);
        self.out().code().side(branch, ROUND, block);
        self.store_counter(variable, counter)?;
        self.block(block)?;
        self.loop_end(stmt);
        let counted = self.out().load(variable, None)?;
        self.out().move_num(counter, counted);
        let body = body.0;
        let next = if is_up { Op::ForNextUp { counter, limit, body } } else { Op::ForNext { counter, limit, body } };
        self.out().code().next_round(next);
        self.out().code().place(exit);
        self.out().code().side(branch, END, &[]);
        self.store_counter(variable, counter)
    }

    fn step(&mut self, step: Option<ExprId>, to: Register) -> Result<()> {
        match step {
            Some(step) => self.values.num_to(step, to),
            None => {
                let one = self.out().frame_mut().constant(1.0)?;
                self.out().move_num(to, one);
                Ok(())
            }
        }
    }

    /// Stores a counter that is not on the frame. It is counted in a register, and stored before and after each
    /// iteration.
    fn store_counter(&mut self, variable: CompiledValue, counter: Register) -> Result<()> {
        match variable.location {
            ValueLocator::Frame(_) => Ok(()),
            location => self.out().store(location, counter),
        }
    }

    /// Returns the location of the same variable, even if the block changes the variables in the index.
    fn pinned(&mut self, location: ValueLocator) -> Result<ValueLocator> {
        let ValueLocator::Element { container, at, plain } = location else { return Ok(location) };
        let at = match at {
            Subscript::One(index) => Subscript::One(self.out().kept(index)?),
            Subscript::Two([i, j]) => Subscript::Two([self.out().kept(i)?, self.out().kept(j)?]),
            Subscript::Key(key) => Subscript::Key(text_register(self.out().kept_text(key)?)?),
            at @ (Subscript::Whole | Subscript::Three(_)) => at,
        };
        Ok(ValueLocator::Element { container, at, plain })
    }
}
