//! Statements. Each simple one is an instruction line, and so is each condition (5.4).

use val3_analysis::body::{ExprId, Stmt, StmtKind};
use val3_bytecode::{Callee, InstructionSite, Op};
use val3_syntax::TextRange;

use crate::coder::Coder;
use crate::error::{Limit, Result};

impl Coder<'_, '_> {
    /// Compiles statements in sequence. The temporaries of each are released after it.
    pub(crate) fn block(&mut self, block: &[Stmt]) -> Result<()> {
        for stmt in block {
            self.range = stmt.range;
            let mark = self.frame.mark();
            self.stmt(stmt)?;
            self.frame.release(mark);
        }
        Ok(())
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
            _ => self.code.line(stmt.range),
        }
        match &stmt.kind {
            StmtKind::Return => {
                self.emit(Op::Return);
                return Ok(());
            }
            StmtKind::Call(call) => self.or_stop(&self.call_parts(*call), |coder| coder.call_stmt(*call)),
            StmtKind::TaskCreate { synchronous, arguments } => {
                let (call, before) = arguments.split_last().ok_or(Limit::Unclear)?;
                let ids = [before, &self.call_parts(*call)].concat();
                self.or_stop(&ids, |coder| coder.task_create(*synchronous, arguments))
            }
            StmtKind::Print(value) => self.or_stop(&[*value], |coder| coder.print(*value)),
            StmtKind::Assign { target, value } => {
                self.or_stop(&[*target, *value], |coder| coder.assign(*target, *value).map(drop))
            }
            StmtKind::Expr(id) => self.or_stop(&[*id], |coder| coder.instruction_stmt(*id)),
            _ => return Err(Limit::Unclear),
        }?;
        Ok(())
    }

    fn if_stmt(&mut self, stmt: &Stmt, arms: &[(Option<ExprId>, Vec<Stmt>)], otherwise: Option<&[Stmt]>) -> Result<()> {
        let end = self.code.label();
        for (number, (condition, block)) in arms.iter().enumerate() {
            let condition = condition.ok_or(Limit::Unclear)?;
            let next = self.code.label();
            let range = self.body.range(condition);
            self.code.line(if number == 0 { head(stmt, range) } else { range });
            self.condition(condition, false, next)?;
            self.block(block)?;
            if number + 1 < arms.len() || otherwise.is_some() {
                self.emit(Op::Jump { to: end.0 });
            }
            self.code.place(next);
        }
        self.block(otherwise.unwrap_or_default())?;
        self.code.place(end);
        Ok(())
    }

    /// A jump on a condition, whose temporaries are released.
    pub(crate) fn condition(&mut self, id: ExprId, when: bool, label: crate::code::Label) -> Result<()> {
        let mark = self.frame.mark();
        self.or_stop(&[id], |coder| coder.branch(id, when, label))?;
        self.frame.release(mark);
        Ok(())
    }

    /// `? value`
    fn print(&mut self, id: ExprId) -> Result<()> {
        let value = self.value(id, None)?;
        let mut site = InstructionSite::new(Callee::Print(self.unit.items.arm));
        let argument = self.argument_of(value)?;
        site.arguments.push(argument);
        self.code.instruction(site);
        Ok(())
    }
}

/// A statement up to the end of its condition.
pub(crate) fn head(stmt: &Stmt, condition: TextRange) -> TextRange {
    TextRange::new(stmt.range.start(), condition.end().max(stmt.range.start()))
}
