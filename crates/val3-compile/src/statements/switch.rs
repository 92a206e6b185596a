//! `switch`: the cases are compared in sequence, all in the line of the statement (2.2.5).

use val3_analysis::body::{ExprId, Stmt};
use val3_bytecode::Op;
use val3_lang::types::BaseType;
use val3_syntax::TextRange;

use crate::code::Label;
use crate::counting::NO_CASE;
use crate::emitter::text_register;
use crate::error::{CompileLimit, Result};
use crate::location::{CompiledValue, is_number};
use crate::statements::Statements;
use crate::statements::head;

/// The values of a `case`, empty for `default`, and its block.
type Case = (Vec<ExprId>, Vec<Stmt>);

impl Statements<'_, '_> {
    pub(crate) fn switch_stmt(&mut self, stmt: &Stmt, selector: Option<ExprId>, cases: &[Case]) -> Result<()> {
        let selector = selector.ok_or(CompileLimit::Unclear)?;
        let range = head(stmt, self.values.body().range(selector));
        self.out().code().line(range);
        let labels: Vec<Label> = cases.iter().map(|_| self.out().code().label()).collect();
        let mark = self.out().frame_mut().mark();
        let compared: Vec<ExprId> =
            std::iter::once(selector).chain(cases.iter().flat_map(|(ids, _)| ids).copied()).collect();
        self.or_stop(&compared, |statements| statements.comparisons(selector, cases, &labels))?;
        self.out().frame_mut().release(mark);
        self.case_blocks(stmt, cases, &labels, range)
    }

    /// Compiles the blocks, and the jump past them.
    fn case_blocks(&mut self, stmt: &Stmt, cases: &[Case], labels: &[Label], range: TextRange) -> Result<()> {
        let branch = self.out().code().branch(range);
        let (end, none) = (self.out().code().label(), self.out().code().label());
        let default = cases.iter().zip(labels).find(|((values, _), _)| values.is_empty());
        self.out().emit(Op::Jump { to: default.map_or(none, |(_, label)| *label).0 });
        for (number, ((values, block), label)) in cases.iter().zip(labels).enumerate() {
            self.out().code().place(*label);
            let name = self.case_name(values);
            self.out().code().side(branch, &name, block);
            self.block(block)?;
            if let Some(closing) = self.closings.of_case(stmt.range, number) {
                self.out().code().closing(closing);
            }
            self.out().emit(Op::Jump { to: end.0 });
        }
        self.out().code().place(none);
        if default.is_none() {
            self.out().code().side(branch, NO_CASE, &[]);
        }
        self.out().code().place(end);
        Ok(())
    }

    /// Returns the name of a case as a branch side, as in the source.
    fn case_name(&mut self, values: &[ExprId]) -> String {
        let ranges = values.iter().map(|id| self.values.body().range(*id)).reduce(TextRange::cover);
        ranges.map_or_else(|| "default".to_owned(), |range| format!("case {}", self.out().source(range)))
    }

    fn comparisons(&mut self, selector: ExprId, cases: &[Case], labels: &[Label]) -> Result<()> {
        let base = self.values.base(selector);
        let value = self.values.value(selector, None)?;
        if base.builtin() == Some(BaseType::String) {
            return self.text_cases(value, cases, labels);
        }
        let value = self.out().settled(value)?;
        let by_number = base.builtin().is_some_and(|base| is_number(base) || base == BaseType::Dio);
        for ((values, _), label) in cases.iter().zip(labels) {
            for id in values {
                let mark = self.out().frame_mut().mark();
                if by_number { self.number_case(value, *id, *label) } else { self.other_case(value, *id, *label) }?;
                self.out().frame_mut().release(mark);
            }
        }
        Ok(())
    }

    /// Compiles the comparisons with a string, which is compared in place if no case can change it.
    fn text_cases(&mut self, selector: CompiledValue, cases: &[Case], labels: &[Label]) -> Result<()> {
        let a = self.out().text_operand(selector.location)?;
        let a = if self.values.is_stable(a) { a } else { text_register(self.out().kept_text(a)?)? };
        for ((values, _), label) in cases.iter().zip(labels) {
            for id in values {
                let mark = self.out().frame_mut().mark();
                let b = self.values.text(*id)?;
                self.out().emit(Op::IfTextEqual { a, b, to: label.0 });
                self.out().frame_mut().release(mark);
            }
        }
        Ok(())
    }

    fn number_case(&mut self, selector: CompiledValue, id: ExprId, label: Label) -> Result<()> {
        let (a, b) = (self.out().load(selector, None)?, self.values.num(id)?);
        self.out().emit(Op::IfEqual { a, b, to: label.0 });
        Ok(())
    }

    fn other_case(&mut self, selector: CompiledValue, id: ExprId, label: Label) -> Result<()> {
        let condition = self.values.compare_equal(selector, id)?;
        self.out().emit(Op::JumpIf { condition, to: label.0 });
        Ok(())
    }
}
