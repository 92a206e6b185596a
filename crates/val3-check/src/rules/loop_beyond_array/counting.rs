//! Loops that count by 1, up or down, and the values of their counter.

use val3_analysis::body::{Expr, ExprId, Stmt, StmtKind};
use val3_analysis::effects::{AccessKind, RootVariable};
use val3_lang::instructions::SIZE;
use val3_lang::operators::BinaryOp;

use crate::lint::ProgramView;

/// A whole number, or the size of an array and a whole number.
#[derive(Clone, Copy)]
pub(super) struct Bound {
    /// The array in `size(array)`.
    pub(super) size_of: Option<ExprId>,
    /// The number that is added to the size.
    pub(super) offset: f64,
}

impl Bound {
    fn new(program: &ProgramView<'_>, id: ExprId) -> Option<Self> {
        let id = program.body.without_parentheses(id);
        if let Some(number) = program.body.number(id) {
            return (number.fract() == 0.0).then_some(Self { size_of: None, offset: number });
        }
        if let Some(array) = size_of(program, id) {
            return Some(Self { size_of: Some(array), offset: 0.0 });
        }
        let (base, offset) = shift(program, id)?;
        Some(Self::new(program, base)?.shifted(offset))
    }

    pub(super) fn shifted(self, offset: f64) -> Self {
        Self { offset: self.offset + offset, ..self }
    }

    /// The bound as code: `size(nParts)+1`.
    pub(super) fn text(self, program: &ProgramView<'_>) -> String {
        let Some(array) = self.size_of else { return self.offset.to_string() };
        let size = format!("size({})", program.text(array));
        if self.offset == 0.0 { size } else { format!("{size}{:+}", self.offset) }
    }

    /// The lowest value. An array has at least one element: no pass of a loop over an empty array is executed.
    fn lowest(self) -> f64 {
        if self.size_of.is_some() { self.offset + 1.0 } else { self.offset }
    }
}

/// A loop that counts by 1 and is executed at least once.
pub(super) struct CountingLoop<'p> {
    pub(super) counter: ExprId,
    /// Start of a `for`, or value that the line before a `do` assigns.
    pub(super) start: Option<ExprId>,
    /// Limit in the head of the loop.
    pub(super) stop: ExprId,
    pub(super) is_descending: bool,
    /// Lowest value of the counter, if it is known.
    pub(super) lowest: Option<f64>,
    /// Highest value of the counter.
    pub(super) highest: Bound,
    pub(super) block: &'p [Stmt],
}

impl<'p> CountingLoop<'p> {
    pub(super) fn new(program: &ProgramView<'_>, stmt: &'p Stmt) -> Option<Self> {
        let counting =
            for_loop(program, stmt).or_else(|| while_loop(program, stmt)).or_else(|| do_loop(program, stmt))?;
        let is_name = matches!(program.body.expr(counting.counter), Expr::Name(_));
        (is_name && !is_changed_by_call(program, stmt, counting.counter)).then_some(counting)
    }

    /// Difference between an index and the counter: 1 for `nParts[nI+1]`.
    pub(super) fn offset(&self, program: &ProgramView<'_>, index: ExprId) -> Option<f64> {
        let index = program.body.without_parentheses(index);
        if program.is_same(index, self.counter) {
            return Some(0.0);
        }
        let (base, offset) = shift(program, index)?;
        Some(self.offset(program, base)? + offset)
    }
}

fn for_loop<'p>(program: &ProgramView<'_>, stmt: &'p Stmt) -> Option<CountingLoop<'p>> {
    let StmtKind::For { counter, start, stop, step, block } = &stmt.kind else { return None };
    let (counter, start, stop) = ((*counter)?, (*start)?, (*stop)?);
    let is_descending = match step.map(|step| program.body.number(step)) {
        None | Some(Some(1.0)) => false,
        Some(Some(-1.0)) => true,
        Some(_) => return None,
    };
    let (low, high) = if is_descending { (stop, start) } else { (start, stop) };
    let (low, highest) = (Bound::new(program, low)?, Bound::new(program, high)?);
    let is_executed = low.size_of.is_none() && low.offset <= highest.lowest();
    let (lowest, start) = (Some(low.offset), Some(start));
    (is_executed && writes(program, stmt, counter) == 0).then_some(CountingLoop {
        counter,
        start,
        stop,
        is_descending,
        lowest,
        highest,
        block,
    })
}

fn while_loop<'p>(program: &ProgramView<'_>, stmt: &'p Stmt) -> Option<CountingLoop<'p>> {
    let StmtKind::While { condition, block } = &stmt.kind else { return None };
    let (counter, stop, offset) = match program.body.expr(program.body.without_parentheses((*condition)?)) {
        Expr::Binary(BinaryOp::LessOrEqual, counter, stop) => (*counter, *stop, 0.0),
        Expr::Binary(BinaryOp::GreaterOrEqual, stop, counter) => (*counter, *stop, 0.0),
        Expr::Binary(BinaryOp::Less, counter, stop) => (*counter, *stop, -1.0),
        Expr::Binary(BinaryOp::Greater, stop, counter) => (*counter, *stop, -1.0),
        _ => return None,
    };
    let highest = Bound::new(program, stop)?.shifted(offset);
    let counts = block.iter().any(|stmt| is_increment(program, stmt, counter));
    let is_certain = counts && writes(program, stmt, counter) == 1;
    let (start, lowest, is_descending) = (None, None, false);
    is_certain.then_some(CountingLoop { counter, start, stop, is_descending, lowest, highest, block })
}

/// A `do` whose counter is set by the line before it.
fn do_loop<'p>(program: &ProgramView<'_>, stmt: &'p Stmt) -> Option<CountingLoop<'p>> {
    let StmtKind::Do { block, condition } = &stmt.kind else { return None };
    let (counter, stop, offset) = match program.body.expr(program.body.without_parentheses((*condition)?)) {
        Expr::Binary(BinaryOp::Greater, counter, stop) => (*counter, *stop, 0.0),
        Expr::Binary(BinaryOp::Less, stop, counter) => (*counter, *stop, 0.0),
        Expr::Binary(BinaryOp::GreaterOrEqual | BinaryOp::Equal, counter, stop) => (*counter, *stop, -1.0),
        Expr::Binary(BinaryOp::LessOrEqual, stop, counter) => (*counter, *stop, -1.0),
        _ => return None,
    };
    let StmtKind::Assign { target, value: start } = statement_before(program, stmt)?.kind else { return None };
    let lowest = program.body.number(start).filter(|start| start.fract() == 0.0)?;
    let highest = Bound::new(program, stop)?.shifted(offset);
    let counts = block.iter().any(|stmt| is_increment(program, stmt, counter)) && writes(program, stmt, counter) == 1;
    let is_certain = counts && program.is_same(target, counter) && lowest <= highest.lowest();
    let (start, lowest, is_descending) = (Some(start), Some(lowest), false);
    is_certain.then_some(CountingLoop { counter, start, stop, is_descending, lowest, highest, block })
}

/// The statement directly before `stmt` in the same block.
fn statement_before<'p>(program: &'p ProgramView<'_>, stmt: &Stmt) -> Option<&'p Stmt> {
    let block = program.body.blocks().find(|block| block.iter().any(|other| other.range == stmt.range))?;
    block.iter().take_while(|other| other.range != stmt.range).last()
}

/// Whether the statement is `n=n+1`.
pub(super) fn is_increment(program: &ProgramView<'_>, stmt: &Stmt, counter: ExprId) -> bool {
    let StmtKind::Assign { target, value } = stmt.kind else { return false };
    let Expr::Binary(BinaryOp::Add, left, right) = program.body.expr(program.body.without_parentheses(value)) else {
        return false;
    };
    program.is_same(target, counter) && program.is_same(*left, counter) && program.body.number(*right) == Some(1.0)
}

/// Number of accesses in a loop that may write the counter, without the write of `for` itself.
fn writes(program: &ProgramView<'_>, stmt: &Stmt, counter: ExprId) -> usize {
    let root = program.effects.root(counter);
    let inside = program.effects.all().iter().filter(|access| {
        access.kind != AccessKind::Read && access.id != counter && stmt.range.contains_range(program.range(access.id))
    });
    inside.filter(|access| Some(&access.root) == root.as_ref()).count()
}

/// Whether a program that the loop calls may write the counter.
fn is_changed_by_call(program: &ProgramView<'_>, stmt: &Stmt, counter: ExprId) -> bool {
    let calls = || stmt.with_inner().iter().any(|inner| matches!(inner.kind, StmtKind::Call(_)));
    match program.effects.root(counter) {
        Some(RootVariable::Local(_)) => false,
        Some(RootVariable::Data(name)) => calls() && program.may_change_elsewhere(&name),
        _ => calls(),
    }
}

/// The other operand and the whole number that a sum adds to it: `nI` and 1 for `nI+1`, `1+nI` and `nI-(-1)`.
fn shift(program: &ProgramView<'_>, id: ExprId) -> Option<(ExprId, f64)> {
    let whole = |id| program.body.number(id).filter(|number| number.fract() == 0.0);
    match program.body.expr(id) {
        Expr::Binary(BinaryOp::Add, left, right) => {
            whole(*right).map(|number| (*left, number)).or_else(|| whole(*left).map(|number| (*right, number)))
        }
        Expr::Binary(BinaryOp::Subtract, left, right) => Some((*left, -whole(*right)?)),
        _ => None,
    }
}

/// The array in `size(array)`.
pub(super) fn size_of(program: &ProgramView<'_>, limit: ExprId) -> Option<ExprId> {
    let call = program.call_of(program.body.without_parentheses(limit)).filter(|call| call.instruction.name == SIZE)?;
    match *call.args {
        [array] => Some(array),
        _ => None,
    }
}
