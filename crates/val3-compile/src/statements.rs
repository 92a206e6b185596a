//! Statements. Each simple statement and each condition is an instruction line (5.4).

pub(crate) mod calls;
mod conditions;
mod loops;
mod missing;
mod switch;

use val3_analysis::body::{Constant, Expr, ExprId, Stmt, StmtKind};
use val3_analysis::items::program::Header;
use val3_bytecode::{Callee, InstructionSite, Op};
use val3_syntax::TextRange;

use crate::closings::Closings;
use crate::counting::{BranchId, FALSE, TRUE};
use crate::emitter::Emitter;
use crate::error::{CompileLimit, Result};
use crate::expressions::Expressions;
use crate::layout::BLOCK_END;

use missing::{Missing, unknown_meaning};

/// Compiles the statements of a program.
pub(crate) struct Statements<'u, 'db> {
    /// Compiler for expressions.
    values: Expressions<'u, 'db>,
    header: &'db Header,
    /// Keywords that close the blocks.
    closings: Closings,
    /// Range of the present statement.
    range: TextRange,
}

impl<'u, 'db> Statements<'u, 'db> {
    /// Creates the compiler for the statements of a program with this header.
    pub(crate) fn new(values: Expressions<'u, 'db>, header: &'db Header, closings: Closings) -> Self {
        Self { values, header, closings, range: TextRange::default() }
    }

    /// Marks the next operation as the stop at `end`.
    pub(crate) fn end(&mut self) {
        if let Some(end) = self.closings.end {
            self.out().code().closing(end);
        }
    }

    /// Adds the stop at the keyword that closes a loop.
    pub(crate) fn loop_end(&mut self, stmt: &Stmt) {
        if let Some(closing) = self.closings.of_loop(stmt.range) {
            self.out().code().closing(closing);
            self.out().emit(Op::Line);
        }
    }

    /// Returns the program's output: frame, code and tables.
    pub(crate) fn out(&mut self) -> &mut Emitter<'u, 'db> {
        self.values.out()
    }

    /// Returns the compiler for expressions.
    pub(crate) fn values(&mut self) -> &mut Expressions<'u, 'db> {
        &mut self.values
    }

    /// Returns the row of the present statement.
    pub(crate) fn row(&mut self) -> u32 {
        let range = self.range;
        self.out().code().row(range)
    }

    /// Compiles a sequence of statements. The temporaries are released after each statement.
    pub(crate) fn block(&mut self, block: &[Stmt]) -> Result<()> {
        for stmt in block {
            self.range = stmt.range;
            let has_lasting_values = matches!(stmt.kind, StmtKind::For { .. } | StmtKind::Switch { .. });
            self.begin_step(stmt.range, has_lasting_values);
            let mark = self.out().frame_mut().mark();
            self.stmt(stmt)?;
            self.out().frame_mut().release(mark);
        }
        self.out().frame_mut().begin_step(BLOCK_END, false);
        Ok(())
    }

    /// Begins a part of the code whose registers a replaced line must not change.
    fn begin_step(&mut self, range: TextRange, has_lasting_values: bool) {
        if self.out().frame().keeps_layout() {
            let row = self.out().code().row(range);
            self.out().frame_mut().begin_step(row, has_lasting_values);
        }
    }

    fn stmt(&mut self, stmt: &Stmt) -> Result<()> {
        match &stmt.kind {
            StmtKind::If { arms, otherwise } => return self.if_stmt(stmt, arms, otherwise.as_deref()),
            StmtKind::While { condition, block } => return self.while_stmt(stmt, *condition, block),
            StmtKind::Do { block, condition } => return self.do_stmt(*condition, block),
            StmtKind::For { counter, start, stop, step, block } => {
                return self.for_stmt(stmt, [*counter, *start, *stop, *step], block);
            }
            StmtKind::Switch { selector, cases } => return self.switch_stmt(stmt, *selector, cases),
            _ => self.out().code().line(stmt.range),
        }
        match &stmt.kind {
            StmtKind::Return => {
                // A task may stop before its end, after this line.
                self.out().code().begin();
                self.out().emit(Op::Return);
                return Ok(());
            }
            StmtKind::Call(call) => self.or_stop(&self.call_parts(*call), |statements| statements.call_stmt(*call)),
            StmtKind::TaskCreate { synchronous, arguments } => {
                let (call, before) = arguments.split_last().ok_or(CompileLimit::Unclear)?;
                let ids = [before, &self.call_parts(*call)].concat();
                self.or_stop(&ids, |statements| statements.task_create(*synchronous, arguments))
            }
            StmtKind::Print(value) => self.or_stop(&[*value], |statements| statements.print(*value)),
            StmtKind::Assign { target, value } => {
                self.or_stop(&[*target, *value], |statements| statements.values.assign(*target, *value).map(drop))
            }
            StmtKind::Expr(id) => self.or_stop(&[*id], |statements| statements.values.instruction_stmt(*id)),
            _ => return Err(CompileLimit::Unclear),
        }?;
        Ok(())
    }

    fn if_stmt(&mut self, stmt: &Stmt, arms: &[(Option<ExprId>, Vec<Stmt>)], otherwise: Option<&[Stmt]>) -> Result<()> {
        let end = self.out().code().label();
        for (number, (condition, block)) in arms.iter().enumerate() {
            let condition = condition.ok_or(CompileLimit::Unclear)?;
            let next = self.out().code().label();
            let range = self.values.body().range(condition);
            self.out().code().line(if number == 0 { head(stmt, range) } else { range });
            let branch = self.branch_at(condition);
            self.condition(condition, false, next)?;
            self.out().code().side(branch, TRUE, block);
            self.block(block)?;
            let is_last = number + 1 == arms.len();
            if !is_last || otherwise.is_some() || branch.is_some() {
                self.out().emit(Op::Jump { to: end.0 });
            }
            self.out().code().place(next);
            self.out().code().side(branch, FALSE, otherwise.filter(|_| is_last).unwrap_or_default());
        }
        self.block(otherwise.unwrap_or_default())?;
        self.out().code().place(end);
        Ok(())
    }

    /// Declares the branch of a condition. A constant condition has no branch.
    pub(crate) fn branch_at(&mut self, condition: ExprId) -> Option<BranchId> {
        let range = self.values.body().range(condition);
        match self.values.body().constant(condition) {
            Some(Constant::Bool(_)) => None,
            _ => self.out().code().branch(range),
        }
    }

    /// Compiles a jump on a condition, and releases the temporaries.
    pub(crate) fn condition(&mut self, id: ExprId, when: bool, label: crate::code::Label) -> Result<()> {
        self.begin_step(self.values.body().range(id), false);
        let mark = self.out().frame_mut().mark();
        self.or_stop(&[id], |statements| statements.branch(id, when, label))?;
        self.out().frame_mut().release(mark);
        Ok(())
    }

    /// Compiles `? value`.
    fn print(&mut self, id: ExprId) -> Result<()> {
        let value = self.values.value(id, None)?;
        let mut site = InstructionSite::new(Callee::Print(self.values.unit().items.arm));
        let argument = self.out().argument_of(value)?;
        site.arguments.push(argument);
        self.out().code().instruction(site);
        Ok(())
    }

    /// Compiles a line that uses these expressions. If something is unresolved, the line stops its task instead, and
    /// the result is `None`.
    pub(crate) fn or_stop<T>(
        &mut self,
        ids: &[ExprId],
        compile: impl FnOnce(&mut Self) -> Result<T>,
    ) -> Result<Option<T>> {
        let (code, frame) = (self.out().code().mark(), self.out().frame_mut().mark());
        self.values.begin(ids);
        match compile(self) {
            Err(CompileLimit::Unclear) => {
                self.out().code().take_back(code);
                self.out().frame_mut().release(frame);
                let missing = ids.iter().find_map(|id| Missing::new(self).of(*id));
                self.out().code().instruction(missing.unwrap_or_else(unknown_meaning));
                Ok(None)
            }
            done => done.map(Some),
        }
    }

    /// Returns the callee and the arguments of a program call.
    pub(crate) fn call_parts(&self, call: ExprId) -> Vec<ExprId> {
        match self.values.body().expr(call) {
            Expr::Call(callee, args) => std::iter::once(*callee).chain(args.iter().copied()).collect(),
            _ => Vec::new(),
        }
    }
}

/// Returns the range of a statement up to the end of its condition.
pub(crate) fn head(stmt: &Stmt, condition: TextRange) -> TextRange {
    TextRange::new(stmt.range.start(), condition.end().max(stmt.range.start()))
}
